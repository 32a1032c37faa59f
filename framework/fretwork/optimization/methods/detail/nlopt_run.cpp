// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/methods/detail/nlopt_run.hpp>
#include <fretwork/optimization/methods/detail/unit_box.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace fretwork::optimization::detail {
namespace {

struct Destroy {
    void operator()(nlopt_opt method) const { nlopt_destroy(method); }
};
using Method = std::unique_ptr<nlopt_opt_s, Destroy>;

/// A scaled objective, and its derivative with respect to the objective.
struct Scaled {
    double value;
    double rate;
};

Scaled scaled(double value, ObjectiveScale scale) {
    if (scale == ObjectiveScale::AsItIs) return {value, 1.0};
    return {std::asinh(value), 1.0 / std::hypot(1.0, value)};
}

/// The data of NLopt's callback. No exception may pass through NLopt's C code, so this object stores it.
struct Callback {
    Evaluator& evaluator;
    UnitBox box;
    nlopt_opt method;
    long patience;
    ObjectiveScale scale;
    long evaluations = 0;
    double best = HUGE_VAL;
    long idle = 0;  ///< number of evaluations since the last improvement
    bool is_refused = false;
    bool is_patience_over = false;
    std::exception_ptr error{};

    double evaluate(const Eigen::VectorXd& shares, double* slope) {
        // Some methods finish a batch after a stop.
        if (is_refused || is_patience_over) return HUGE_VAL;
        const double value = value_at(shares, slope);
        ++evaluations;
        idle = value < best ? 0 : idle + 1;
        best = std::min(best, value);
        if (idle >= patience) {
            is_patience_over = true;
            nlopt_force_stop(method);
        }
        return value;
    }

    double value_at(const Eigen::VectorXd& shares, double* slope) {
        const Eigen::VectorXd point = box.point(shares);
        if (slope == nullptr) {
            const auto value = evaluator.value(point);
            return value ? scaled(*value, scale).value : refuse();
        }
        Eigen::Map<Eigen::VectorXd> gradient(slope, shares.size());
        gradient.setZero();
        const auto model = evaluator.gradient(point);
        if (!model) return refuse();
        if (!std::isfinite(model->objective) || !model->gradient.allFinite()) return HUGE_VAL;
        const auto [value, rate] = scaled(model->objective, scale);
        gradient = rate * model->gradient.cwiseProduct(box.rates());
        return value;
    }

    double refuse() {
        is_refused = true;
        nlopt_force_stop(method);
        return HUGE_VAL;
    }
};

double call(unsigned size, const double* shares, double* slope, void* data) noexcept {
    auto& callback = *static_cast<Callback*>(data);
    try {
        return callback.evaluate(Eigen::Map<const Eigen::VectorXd>(shares, size), slope);
    } catch (const std::exception&) {
        callback.error = std::current_exception();
        return callback.refuse();
    }
}

Method make_method(nlopt_algorithm algorithm, const NloptRun& run) {
    Method method(nlopt_create(algorithm, static_cast<unsigned>(run.start.size())));
    nlopt_set_lower_bounds1(method.get(), 0.0);
    nlopt_set_upper_bounds1(method.get(), 1.0);
    nlopt_set_ftol_rel(method.get(), run.tolerance);
    nlopt_set_xtol_rel(method.get(), run.tolerance);
    nlopt_set_initial_step1(method.get(), run.initial_step);
    return method;
}

Ending ending_of(nlopt_result result, const Callback& callback) {
    if (callback.is_refused) return Ending::BudgetSpent;
    const bool is_dead = result < 0 && !callback.is_patience_over && callback.evaluations <= 1;
    if (is_dead || !std::isfinite(callback.best)) return Ending::Invalid;
    return result > 0 && !callback.is_patience_over ? Ending::Converged : Ending::Stalled;
}

}  // namespace

RunOutcome run_nlopt(Evaluator& evaluator, const NloptRun& run) {
    const Method method = make_method(run.algorithm, run);
    if (run.local) {
        // NLopt copies the local method. The outer method never ends by itself, because its tolerances are
        // off.
        const Method local = make_method(*run.local, run);
        nlopt_set_local_optimizer(method.get(), local.get());
        nlopt_set_ftol_rel(method.get(), 0.0);
        nlopt_set_xtol_rel(method.get(), 0.0);
    }
    Callback callback{evaluator, UnitBox(evaluator.problem()), method.get(), run.patience, run.scale};
    nlopt_set_min_objective(method.get(), call, &callback);
    nlopt_srand(run.seed);
    Eigen::VectorXd shares = run.start;
    double value = 0.0;
    const nlopt_result result = nlopt_optimize(method.get(), shares.data(), &value);
    if (callback.error) std::rethrow_exception(callback.error);
    return {ending_of(result, callback), callback.box.point(shares)};
}

}  // namespace fretwork::optimization::detail

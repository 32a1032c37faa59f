// SPDX-License-Identifier: GPL-3.0-or-later
// The only file with a problem of pagmo, because such a problem takes long to compile.
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/detail/pagmo_optimizer.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>
#include <fretwork/optimization/methods/detail/unit_box.hpp>

#include <cmath>
#include <exception>
#include <optional>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

namespace fretwork::optimization::detail {
namespace {

/// The exception that stops pagmo from inside an evaluation; pagmo offers no other way. It never leaves this
/// file.
class Refused final : public std::exception {};

/// The evaluator with the interface of a problem of pagmo. pagmo copies the object; all copies share the
/// evaluator.
class UnitProblem {
  public:
    UnitProblem() = default;  // required by pagmo
    explicit UnitProblem(Evaluator& evaluator) : evaluator_(&evaluator), box_(evaluator.problem()) {}

    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& shares) const {
        const Eigen::Index size = shares.size();
        const auto value =
            evaluator_->value(box_->point(Eigen::Map<const Eigen::VectorXd>(shares.data(), size)));
        if (!value) throw Refused{};
        // Pagmo subtracts values, and the difference of infinite values is NaN.
        return {std::isfinite(*value) ? *value : kHuge};
    }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        const auto size = box_ ? static_cast<std::size_t>(box_->dimension()) : 1;
        return {pagmo::vector_double(size, 0.0), pagmo::vector_double(size, 1.0)};
    }

  private:
    static constexpr double kHuge = 1e100;
    Evaluator* evaluator_ = nullptr;
    std::optional<UnitBox> box_;
};

class PagmoRuns final : public Optimizer {
  public:
    PagmoRuns(MakeEvolution make, const PagmoOptions& options) : make_(make), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        BestRun best(evaluator);
        try {
            for (int i = 0; i < options_.common.starts; ++i) {
                const unsigned seed = base::derived_seed(options_.common.seed, i);
                const Evolution evolution = make_(options_, {evaluator.bounds().dimension(), i, seed});
                const long before = evaluator.evaluations();
                const pagmo::population first{pagmo::problem(UnitProblem(evaluator)), evolution.population,
                                              seed};
                const auto champion = evolution.algorithm.evolve(first).champion_x();
                const bool is_spent = evolution.largest_evaluations &&
                                      evaluator.evaluations() - before >= *evolution.largest_evaluations;
                best.add({is_spent ? Ending::Stalled : Ending::Converged,
                          UnitBox(evaluator.problem())
                              .point(Eigen::Map<const Eigen::VectorXd>(champion.data(), champion.size()))});
            }
        } catch (const Refused&) {
            best.add({Ending::BudgetSpent, evaluator.best_point()});
        }
        return best.outcome();
    }

  private:
    MakeEvolution make_;
    PagmoOptions options_;
};

}  // namespace

std::unique_ptr<Optimizer> make_pagmo_runs(MakeEvolution make, const PagmoOptions& options) {
    options.validate();
    return std::make_unique<PagmoRuns>(make, options);
}

}  // namespace fretwork::optimization::detail

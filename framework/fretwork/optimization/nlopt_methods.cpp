// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/detail/nlopt_run.hpp>
#include <fretwork/optimization/nlopt_methods.hpp>
#include <fretwork/optimization/random.hpp>
#include <fretwork/optimization/sampling.hpp>

namespace fretwork::optimization {
namespace {

/// One run after the other, each from its own point of the low-discrepancy sequence.
class NloptRuns final : public Optimizer {
  public:
    NloptRuns(nlopt_algorithm algorithm, const NloptOptions& options)
        : algorithm_(algorithm), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        const LowDiscrepancySequence starts(evaluator.bounds().dimension(), options_.common.seed);
        RunOutcome outcome{Termination::BudgetSpent, {}};
        for (int i = 0; i < options_.common.starts; ++i) {
            const auto number = static_cast<std::uint64_t>(i);
            outcome = detail::run_nlopt(evaluator, {.algorithm = algorithm_,
                                                    .start = starts.point(number),
                                                    .initial_step = options_.initial_step,
                                                    .tolerance = options_.tolerance,
                                                    .seed = derived_seed(options_.common.seed, number)});
            if (outcome.termination == Termination::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    nlopt_algorithm algorithm_;
    NloptOptions options_;
};

/// One run of a method that has no criterion of its own, from the middle of the box.
class NloptSearch final : public Optimizer {
  public:
    NloptSearch(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local, const NloptOptions& options)
        : algorithm_(algorithm), local_(local), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        return detail::run_nlopt(evaluator,
                                 {.algorithm = algorithm_,
                                  .local = local_,
                                  .start = Eigen::VectorXd::Constant(evaluator.bounds().dimension(), 0.5),
                                  .initial_step = options_.initial_step,
                                  .tolerance = local_ ? options_.tolerance : 0.0,
                                  .patience = options_.patience});
    }

  private:
    nlopt_algorithm algorithm_;
    std::optional<nlopt_algorithm> local_;
    NloptOptions options_;
};

std::unique_ptr<Optimizer> make_runs(nlopt_algorithm algorithm, const NloptOptions& options) {
    options.validate();
    return std::make_unique<NloptRuns>(algorithm, options);
}

std::unique_ptr<Optimizer> make_search(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local,
                                       const NloptOptions& options) {
    options.validate();
    return std::make_unique<NloptSearch>(algorithm, local, options);
}

}  // namespace

void NloptOptions::validate() const {
    common.validate();
    if (!(tolerance > 0.0)) {
        throw base::InputError("tolerance: " + base::format_number(tolerance) + " must be more than 0");
    }
    if (!(initial_step > 0.0 && initial_step <= 1.0)) {
        throw base::InputError("initial step: " + base::format_number(initial_step) +
                               " must be a share of the box, more than 0 and at most 1");
    }
    if (patience < 1) {
        throw base::InputError("patience: " + std::to_string(patience) + " evaluations must be at least 1");
    }
}

std::unique_ptr<Optimizer> make_bobyqa(const NloptOptions& options) {
    return make_runs(NLOPT_LN_BOBYQA, options);
}

std::unique_ptr<Optimizer> make_subplex(const NloptOptions& options) {
    return make_runs(NLOPT_LN_SBPLX, options);
}

std::unique_ptr<Optimizer> make_slsqp(const NloptOptions& options) {
    return make_runs(NLOPT_LD_SLSQP, options);
}

std::unique_ptr<Optimizer> make_crs2(const NloptOptions& options) {
    return make_runs(NLOPT_GN_CRS2_LM, options);
}

std::unique_ptr<Optimizer> make_direct_l(const NloptOptions& options) {
    return make_search(NLOPT_GN_DIRECT_L, std::nullopt, options);
}

std::unique_ptr<Optimizer> make_mlsl(const NloptOptions& options) {
    return make_search(NLOPT_G_MLSL_LDS, NLOPT_LD_SLSQP, options);
}

}  // namespace fretwork::optimization

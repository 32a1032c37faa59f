// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/optimization/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/detail/nlopt_run.hpp>
#include <fretwork/optimization/random.hpp>
#include <fretwork/optimization/sampling.hpp>

namespace fretwork::optimization::detail {
namespace {

class NloptRuns final : public Optimizer {
  public:
    NloptRuns(nlopt_algorithm algorithm, const NloptOptions& options)
        : algorithm_(algorithm), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        const LowDiscrepancySequence starts(evaluator.bounds().dimension(), options_.common.seed);
        RunOutcome outcome{Termination::BudgetSpent, {}};
        for (int i = 0; i < options_.common.starts; ++i) {
            const auto number = static_cast<std::uint64_t>(i);
            outcome = run_nlopt(evaluator, {.algorithm = algorithm_,
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

class NloptSearch final : public Optimizer {
  public:
    NloptSearch(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local, const NloptOptions& options)
        : algorithm_(algorithm), local_(local), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        return run_nlopt(evaluator, {.algorithm = algorithm_,
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

}  // namespace

std::unique_ptr<Optimizer> make_nlopt_runs(nlopt_algorithm algorithm, const NloptOptions& options) {
    options.validate();
    return std::make_unique<NloptRuns>(algorithm, options);
}

std::unique_ptr<Optimizer> make_nlopt_search(nlopt_algorithm algorithm, std::optional<nlopt_algorithm> local,
                                             const NloptOptions& options) {
    options.validate();
    return std::make_unique<NloptSearch>(algorithm, local, options);
}

}  // namespace fretwork::optimization::detail

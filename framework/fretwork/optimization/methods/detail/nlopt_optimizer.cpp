// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/detail/nlopt_optimizer.hpp>
#include <fretwork/optimization/methods/detail/nlopt_run.hpp>
#include <fretwork/optimization/methods/detail/option_checks.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>
#include <fretwork/optimization/sampling.hpp>

namespace fretwork::optimization::detail {
namespace {

class NloptRuns final : public Optimizer {
  public:
    NloptRuns(nlopt_algorithm algorithm, const NloptOptions& options)
        : algorithm_(algorithm), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        const LowDiscrepancySequence starts(evaluator.bounds().dimension(), options_.common.seed);
        BestRun best(evaluator);
        for (int i = 0; i < options_.common.starts; ++i) {
            const std::uint64_t number = i;
            best.add(run_nlopt(evaluator, {.algorithm = algorithm_,
                                           .start = starts.point(number),
                                           .initial_step = options_.initial_step,
                                           .scale = options_.scale,
                                           .tolerance = options_.tolerance,
                                           .seed = base::derived_seed(options_.common.seed, number)}));
            if (best.is_over()) break;
        }
        return best.outcome();
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
                                     .scale = options_.scale,
                                     .tolerance = local_ ? options_.tolerance : 0.0,
                                     .patience = options_.patience});
    }

  private:
    nlopt_algorithm algorithm_;
    std::optional<nlopt_algorithm> local_;
    NloptOptions options_;
};

}  // namespace

void NloptOptions::validate() const {
    common.validate();
    require_more_than(0.0, "tolerance", tolerance);
    if (!(initial_step > 0.0 && initial_step <= 1.0)) {
        throw base::InputError("initial step: " + base::format_number(initial_step) +
                               " must be a share of the box, more than 0 and at most 1");
    }
    require_at_least(1.0, "patience", static_cast<double>(patience));
}

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/annealing_then_ceres.hpp>
#include <fretwork/optimization/methods/detail/ceres_descent.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>

namespace fretwork::optimization {
namespace {

class AnnealingThenCeres final : public Optimizer {
  public:
    explicit AnnealingThenCeres(const AnnealingThenCeresOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        detail::BestRun best(evaluator);
        for (int i = 0; i < options_.annealing.common.starts && !best.is_over(); ++i)
            best.add(run_once(evaluator, base::derived_seed(options_.annealing.common.seed, i)));
        return best.outcome();
    }

  private:
    [[nodiscard]] RunOutcome run_once(Evaluator& evaluator, std::uint64_t seed) const {
        SimulatedAnnealingOptions once = options_.annealing;
        once.common = {.starts = 1, .seed = seed};
        RunOutcome annealed = make_simulated_annealing(once)->run(evaluator);
        const bool has_start = evaluator.best_point().size() > 0;
        return annealed.ending == Ending::BudgetSpent || !has_start ? annealed : descend(evaluator);
    }
    [[nodiscard]] RunOutcome descend(Evaluator& evaluator) const {
        detail::CeresDescent descent(evaluator, options_.continuation, evaluator.best_point());
        RunOutcome outcome;
        for (const double smoothing : options_.continuation.smoothing) {
            outcome = {descent.run_stage(smoothing), descent.point()};
            if (outcome.ending == Ending::BudgetSpent) break;
        }
        return outcome;
    }

    AnnealingThenCeresOptions options_;
};

}  // namespace

void AnnealingThenCeresOptions::validate() const {
    annealing.validate();
    continuation.validate();
}

std::unique_ptr<Optimizer> make_annealing_then_ceres(const AnnealingThenCeresOptions& options) {
    options.validate();
    return std::make_unique<AnnealingThenCeres>(options);
}

}  // namespace fretwork::optimization

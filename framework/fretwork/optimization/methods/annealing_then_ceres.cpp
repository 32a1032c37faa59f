// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/annealing_then_ceres.hpp>
#include <fretwork/optimization/methods/detail/ceres_descent.hpp>

namespace fretwork::optimization {
namespace {

class AnnealingThenCeres final : public Optimizer {
  public:
    explicit AnnealingThenCeres(const AnnealingThenCeresOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome;
        for (int i = 0; i < options_.annealing.common.starts; ++i) {
            SimulatedAnnealingOptions once = options_.annealing;
            once.common = {.starts = 1, .seed = base::derived_seed(options_.annealing.common.seed, i)};
            outcome = make_simulated_annealing(once)->run(evaluator);
            if (outcome.ending == Ending::BudgetSpent || evaluator.best_point().size() == 0) break;
            outcome = descend(evaluator);
            if (outcome.ending == Ending::BudgetSpent) break;
        }
        return outcome;
    }

  private:
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

// SPDX-License-Identifier: GPL-3.0-or-later
// A method from outside the library: the example of docs/guide/own_optimizer.md.
#pragma once

#include <fretwork/base/random.hpp>
#include <fretwork/optimization/optimizer_catalogue.hpp>

namespace own {

using namespace fretwork::optimization;

/// The (1+1) evolution strategy: a random step is taken if it does not lose. Steps grow after a success and
/// shrink after a failure, so that one in five succeeds [Rechenberg1973].
class EvolutionStrategy final : public Optimizer {
  public:
    explicit EvolutionStrategy(const OptimizerOptions& options) : options_(options) { options.validate(); }

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome;
        for (int i = 0; i < options_.starts; ++i) {
            fretwork::base::RandomStream random(options_.seed, static_cast<std::uint64_t>(i));
            outcome = evolve(evaluator, random);
            if (outcome.ending == Ending::BudgetSpent) break;
        }
        return outcome;
    }

  private:
    static RunOutcome evolve(Evaluator& evaluator, fretwork::base::RandomStream& random) {
        const Bounds& bounds = evaluator.bounds();
        Eigen::VectorXd point(bounds.dimension());
        for (double& share : point) share = random.uniform();
        point = bounds.at_shares(point);
        auto value = evaluator.value(point);
        for (double scale = 0.1; value && scale > 1e-5;) {
            Eigen::VectorXd step(point.size());
            for (double& share : step) share = random.laplace(scale);
            const Eigen::VectorXd trial =
                bounds.clamp(point + step.cwiseProduct(bounds.upper - bounds.lower));
            const auto tried = evaluator.value(trial);
            if (!tried) return {Ending::BudgetSpent, point};
            const bool is_success = *tried <= *value;
            if (is_success) {
                point = trial;
                value = tried;
            }
            scale *= is_success ? 1.5 : 0.9;
        }
        return {value ? Ending::Converged : Ending::BudgetSpent, point};
    }

    OptimizerOptions options_;
};

inline const OptimizerRow kEvolutionStrategy{
    "evolution-strategy", "(1+1) evolution strategy with the one-fifth rule", OptimizerClass::Random,
    Evaluation::Value, [](const OptimizerOptions& options) -> std::unique_ptr<Optimizer> {
        return std::make_unique<EvolutionStrategy>(options);
    }};

}  // namespace own

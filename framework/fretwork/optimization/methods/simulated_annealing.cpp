// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/detail/option_checks.hpp>
#include <fretwork/optimization/methods/detail/starts.hpp>
#include <fretwork/optimization/methods/detail/unit_box.hpp>
#include <fretwork/optimization/methods/simulated_annealing.hpp>
#include <fretwork/optimization/sampling.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fretwork::optimization {
namespace {

constexpr double kWantedAcceptance = 0.44;

/// Reflect a share at 0 and 1 until it lies in [0, 1].
double reflected(double share) {
    const double folded = std::fmod(std::abs(share), 2.0);
    return folded > 1.0 ? 2.0 - folded : folded;
}

detail::Scale scale_of(AnnealingVariables variables) {
    return variables == AnnealingVariables::Quantities ? detail::Scale::Quantity : detail::Scale::Variable;
}

/// One run of the published algorithm.
class Annealing {
  public:
    Annealing(const SimulatedAnnealingOptions& options, Evaluator& evaluator, int run)
        : options_(options),
          evaluator_(evaluator),
          box_(evaluator.problem(), scale_of(options.variables)),
          random_(options.common.seed, run),
          shares_(LowDiscrepancySequence(evaluator.bounds().dimension(), options.common.seed).point(run)),
          scales_(Eigen::VectorXd::Constant(shares_.size(), options.initial_move)),
          accepted_(Eigen::VectorXd::Zero(shares_.size())),
          temperature_(options.initial_temperature) {}

    RunOutcome run() {
        const auto first = evaluator_.value(point());
        if (!first) return {Ending::BudgetSpent, point()};
        energy_ = *first;
        for (; moves_ < options_.initial_moves;) {
            if (!try_move()) return {Ending::BudgetSpent, point()};
        }
        return cool();
    }

  private:
    [[nodiscard]] Eigen::VectorXd point() const { return box_.point(shares_); }

    RunOutcome cool() {
        const long frozen_after =
            static_cast<long>(options_.frozen_adaptations) * options_.sweeps_per_adaptation * shares_.size();
        long still_moves = 0;
        for (long move = 0; move < options_.largest_moves; ++move) {
            const double previous = energy_;
            if (!try_move()) return {Ending::BudgetSpent, point()};
            temperature_ *= 1.0 - options_.cooling;
            still_moves = std::abs(energy_ - previous) < options_.tolerance ? still_moves + 1 : 0;
            if (still_moves >= frozen_after) return {Ending::Converged, point()};
        }
        return {Ending::Stalled, point()};
    }

    /// Move the variable whose turn it is. False once the budget is spent.
    bool try_move() {
        const Eigen::Index variable = moves_ % shares_.size();
        const double before = shares_[variable];
        const double wanted = before + random_.laplace(scales_[variable]);
        shares_[variable] = bounded(wanted);
        const auto energy = energy_of(wanted);
        const double chance = random_.uniform();
        if (energy && (*energy <= energy_ || chance < std::exp(-(*energy - energy_) / temperature_))) {
            energy_ = *energy;
            accepted_[variable] += 1.0;
        } else {
            shares_[variable] = before;
        }
        adapt_after(++moves_);
        return energy.has_value();
    }

    [[nodiscard]] double bounded(double share) const {
        return options_.bounds == AnnealingBounds::Reflect ? reflected(share) : std::clamp(share, 0.0, 1.0);
    }

    /// The objective at the moved point, or NaN, which no comparison accepts, if the move is rejected;
    /// nothing once the budget is spent. `wanted` is the share before it is bounded.
    std::optional<double> energy_of(double wanted) {
        const bool is_outside = wanted < 0.0 || wanted > 1.0;
        if (is_outside && options_.bounds == AnnealingBounds::Reject)
            return std::numeric_limits<double>::quiet_NaN();
        return evaluator_.value(point());
    }

    void adapt_after(long moves) {
        if (moves % (options_.sweeps_per_adaptation * shares_.size()) != 0) return;
        for (Eigen::Index i = 0; i < shares_.size(); ++i) {
            const double acceptance = accepted_[i] / options_.sweeps_per_adaptation;
            scales_[i] = std::min(scales_[i] * std::exp(options_.gain * (acceptance - kWantedAcceptance)),
                                  options_.largest_move);
        }
        accepted_.setZero();
    }

    const SimulatedAnnealingOptions& options_;
    Evaluator& evaluator_;
    detail::UnitBox box_;
    base::RandomStream random_;
    Eigen::VectorXd shares_;
    Eigen::VectorXd scales_;
    Eigen::VectorXd accepted_;
    double temperature_;
    double energy_ = 0.0;
    long moves_ = 0;
};

class SimulatedAnnealing final : public Optimizer {
  public:
    explicit SimulatedAnnealing(const SimulatedAnnealingOptions& options) : options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        detail::BestRun best(evaluator);
        for (int run = 0; run < options_.common.starts && !best.is_over(); ++run)
            best.add(Annealing(options_, evaluator, run).run());
        return best.outcome();
    }

  private:
    SimulatedAnnealingOptions options_;
};

}  // namespace

void SimulatedAnnealingOptions::validate() const {
    common.validate();
    detail::require_at_least(1.0, "largest_moves", static_cast<double>(largest_moves));
    detail::require_at_least(0.0, "initial_moves", static_cast<double>(initial_moves));
    detail::require_at_least(1.0, "sweeps_per_adaptation", sweeps_per_adaptation);
    detail::require_at_least(1.0, "frozen_adaptations", frozen_adaptations);
    detail::require_more_than(0.0, "initial_temperature", initial_temperature);
    detail::require_at_least(0.0, "cooling", cooling);
    if (cooling >= 1.0)
        throw base::InputError("cooling: " + base::format_number(cooling) + " must be below 1");
    detail::require_at_least(0.0, "tolerance", tolerance);
    detail::require_more_than(0.0, "initial_move", initial_move);
    detail::require_more_than(0.0, "largest_move", largest_move);
    detail::require_at_least(0.0, "gain", gain);
}

std::unique_ptr<Optimizer> make_simulated_annealing(const SimulatedAnnealingOptions& options) {
    options.validate();
    return std::make_unique<SimulatedAnnealing>(options);
}

}  // namespace fretwork::optimization

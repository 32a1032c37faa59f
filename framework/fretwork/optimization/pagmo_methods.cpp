// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes pagmo, whose headers take long to compile.
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/detail/unit_box.hpp>
#include <fretwork/optimization/pagmo_methods.hpp>
#include <fretwork/optimization/random.hpp>

#include <cmath>
#include <exception>
#include <optional>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/simulated_annealing.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <utility>

namespace fretwork::optimization {
namespace {

/// pagmo has no other way to be stopped from inside an evaluation. Never leaves this file.
class Refused final : public std::exception {};

/// The evaluator in the shape that pagmo asks for. pagmo copies it; all copies share the evaluator.
class UnitProblem {
  public:
    UnitProblem() = default;  // pagmo wants one
    explicit UnitProblem(Evaluator& evaluator) : evaluator_(&evaluator), box_(evaluator.problem()) {}

    [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& shares) const {
        const auto size = static_cast<Eigen::Index>(shares.size());
        const auto value =
            evaluator_->value(box_->point(Eigen::Map<const Eigen::VectorXd>(shares.data(), size)));
        if (!value) throw Refused{};
        // pagmo subtracts values: an infinite one would give NaN.
        return {std::isfinite(*value) ? *value : kHuge};
    }
    [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
        const auto size = box_ ? static_cast<std::size_t>(box_->dimension()) : 1;
        return {pagmo::vector_double(size, 0.0), pagmo::vector_double(size, 1.0)};
    }

  private:
    static constexpr double kHuge = 1e100;
    Evaluator* evaluator_ = nullptr;
    std::optional<detail::UnitBox> box_;
};

/// One run of a method: what evolves, and how many individuals.
struct Evolution {
    pagmo::algorithm algorithm;
    std::size_t population;
};
using MakeEvolution = Evolution (*)(const PagmoOptions& options, int dimension, int run);

unsigned seed_of(const PagmoOptions& options, int run) {
    return derived_seed(options.common.seed, static_cast<std::uint64_t>(run));
}

class PagmoRuns final : public Optimizer {
  public:
    PagmoRuns(MakeEvolution make, const PagmoOptions& options) : make_(make), options_(options) {}

    RunOutcome run(Evaluator& evaluator) const override {
        RunOutcome outcome{Termination::BudgetSpent, {}};
        try {
            for (int i = 0; i < options_.common.starts; ++i) {
                const Evolution evolution = make_(options_, evaluator.bounds().dimension(), i);
                const pagmo::population first{pagmo::problem(UnitProblem(evaluator)), evolution.population,
                                              seed_of(options_, i)};
                const auto champion = evolution.algorithm.evolve(first).champion_x();
                outcome = {Termination::Converged,
                           detail::UnitBox(evaluator.problem())
                               .point(Eigen::Map<const Eigen::VectorXd>(
                                   champion.data(), static_cast<Eigen::Index>(champion.size())))};
            }
        } catch (const Refused&) {
            outcome = {Termination::BudgetSpent, evaluator.best_point()};
        }
        return outcome;
    }

  private:
    MakeEvolution make_;
    PagmoOptions options_;
};

Evolution cma_es(const PagmoOptions& options, int dimension, int run) {
    constexpr double kAutomatic = -1.0;
    constexpr double kInitialStep = 0.3;
    constexpr int kLargestDoubling = 12;
    const auto smallest = static_cast<std::size_t>(4.0 + 3.0 * std::log(dimension));
    return {pagmo::algorithm(pagmo::cmaes(static_cast<unsigned>(options.largest_generations), kAutomatic,
                                          kAutomatic, kAutomatic, kAutomatic, kInitialStep, options.tolerance,
                                          options.tolerance, false, true, seed_of(options, run))),
            std::max<std::size_t>(smallest, 5) << std::min(run, kLargestDoubling)};
}

Evolution differential_evolution(const PagmoOptions& options, int dimension, int run) {
    constexpr double kWeight = 0.8;
    constexpr double kCrossover = 0.9;
    constexpr unsigned kRandOneExp = 2;
    return {
        pagmo::algorithm(pagmo::de(static_cast<unsigned>(options.largest_generations), kWeight, kCrossover,
                                   kRandOneExp, options.tolerance, options.tolerance, seed_of(options, run))),
        std::max<std::size_t>(10 * static_cast<std::size_t>(dimension), 5)};
}

Evolution corana_annealing(const PagmoOptions& options, int /*dimension*/, int run) {
    constexpr double kFirstTemperature = 10.0;
    constexpr double kLastTemperature = 0.1;
    constexpr unsigned kTemperatures = 10;
    constexpr unsigned kRangeAdjustments = 10;
    constexpr unsigned kMovesForAdjustment = 20;
    constexpr double kFirstRange = 1.0;
    return {pagmo::algorithm(pagmo::simulated_annealing(kFirstTemperature, kLastTemperature, kTemperatures,
                                                        kRangeAdjustments, kMovesForAdjustment, kFirstRange,
                                                        seed_of(options, run))),
            1};
}

std::unique_ptr<Optimizer> make_runs(MakeEvolution make, const PagmoOptions& options) {
    options.validate();
    return std::make_unique<PagmoRuns>(make, options);
}

}  // namespace

void PagmoOptions::validate() const {
    common.validate();
    if (!(tolerance >= 0.0)) {
        throw base::InputError("tolerance: " + base::format_number(tolerance) + " must be at least 0");
    }
    if (largest_generations < 1) {
        throw base::InputError("generations: " + std::to_string(largest_generations) + " must be at least 1");
    }
}

std::unique_ptr<Optimizer> make_cma_es(const PagmoOptions& options) {
    return make_runs(cma_es, options);
}

std::unique_ptr<Optimizer> make_differential_evolution(const PagmoOptions& options) {
    return make_runs(differential_evolution, options);
}

std::unique_ptr<Optimizer> make_corana_annealing(const PagmoOptions& options) {
    return make_runs(corana_annealing, options);
}

}  // namespace fretwork::optimization

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/design/swaps/annealing.hpp>
#include <fretwork/design/swaps/swap_table.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostPasses = 8;
constexpr int kBisections = 10;

/// Prices of the quantities that have limits.
struct Prices {
    double energy = 0.0;
    double mass = 0.0;
};

/// A factorization of the unknowns' effects, in units of their largest steps. If unknowns have nearly the
/// same effect, as thickness and a factor on the loads have, it gives the smallest steps.
using StepDecomposition = Eigen::CompleteOrthogonalDecomposition<MatrixXd>;
constexpr double kSameEffect = 1e-6;

StepDecomposition step_decomposition_of(const SwapTable& table) {
    StepDecomposition factors;
    factors.setThreshold(kSameEffect);
    factors.compute(table.by_unknowns * table.largest_steps.asDiagonal());
    return factors;
}

MatrixXd basis_of(const StepDecomposition& factors, Index rows) {
    return factors.householderQ() * MatrixXd::Identity(rows, factors.rank());
}

class Sweeper {
  public:
    Sweeper(const SwapTable& table, const SweepOptions& options) : table_(table), options_(options) {
        squares_.resize(table.energies.rows(), table.energies.cols());
        for (std::size_t g = 0; g < table.groups(); ++g)
            squares_.col(static_cast<Index>(g)) = table.responses[g].colwise().squaredNorm().transpose();
        if (table.by_unknowns.cols() > 0) {
            decomposition_ = step_decomposition_of(table);
            unknowns_ = basis_of(decomposition_, table.by_unknowns.rows());
        }
    }

    [[nodiscard]] Choice run(const std::vector<std::size_t>& start, const Prices& prices,
                             std::uint64_t seed) const {
        Choice choice{start, VectorXd::Zero(table_.by_unknowns.cols())};
        VectorXd residual = residual_of(choice);
        base::SplitMix64 random(seed);
        std::vector<std::size_t> order(table_.groups());
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (int pass = 0; pass < kMostPasses; ++pass) {
            for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
            options_.control.check();
            bool is_changed = false;
            for (const std::size_t group : order)
                is_changed = choose(group, prices, choice, residual) || is_changed;
            step_factors(choice, residual);
            if (!is_changed) break;
        }
        return judged(std::move(choice), residual);
    }

    /// Anneals a choice that is within the limit (annealing.hpp).
    [[nodiscard]] Choice anneal(const Choice& start, double most_energy) const {
        Annealed found = anneal_choice(table_, unknowns_,
                                       {.start = start,
                                        .allowed = options_.allowed,
                                        .most_energy = most_energy,
                                        .proposals = options_.proposals,
                                        .seed = options_.seed,
                                        .control = options_.control});
        scored_ += found.scored;
        return finished(found.columns);
    }

    [[nodiscard]] long scored() const { return scored_; }

    [[nodiscard]] double mass(const Choice& choice) const {
        double sum = 0.0;
        for (std::size_t g = 0; g < choice.columns.size(); ++g)
            sum += table_.masses(static_cast<Index>(choice.columns[g]), static_cast<Index>(g));
        return sum;
    }

  private:
    [[nodiscard]] Choice judged(Choice choice, const VectorXd& residual) const {
        choice.objective = table_.unreached + residual.squaredNorm();
        choice.energy = 0.0;
        for (std::size_t g = 0; g < choice.columns.size(); ++g) choice.energy += energy(g, choice.columns[g]);
        return choice;
    }
    /// These columns with the best steps of the unknowns.
    [[nodiscard]] Choice finished(const std::vector<std::size_t>& columns) const {
        Choice choice{columns, VectorXd::Zero(table_.by_unknowns.cols())};
        VectorXd residual = residual_of(choice);
        step_factors(choice, residual);
        return judged(std::move(choice), residual);
    }
    [[nodiscard]] double energy(std::size_t group, std::size_t column) const {
        return table_.energies(static_cast<Index>(column), static_cast<Index>(group));
    }
    [[nodiscard]] VectorXd residual_of(const Choice& choice) const {
        VectorXd residual = table_.residual;
        for (std::size_t g = 0; g < choice.columns.size(); ++g)
            residual += table_.responses[g].col(static_cast<Index>(choice.columns[g]));
        if (choice.steps.size() > 0) residual += table_.by_unknowns * choice.steps;
        return residual;
    }

    bool choose(std::size_t group, const Prices& prices, Choice& choice, VectorXd& residual) const {
        const auto g = static_cast<Index>(group);
        const MatrixXd& responses = table_.responses[group];
        const auto old = static_cast<Index>(choice.columns[group]);
        residual -= responses.col(old);
        scored_ += responses.cols();
        VectorXd costs = 2.0 * (responses.transpose() * residual) + squares_.col(g);
        costs += prices.energy * table_.energies.col(g) + prices.mass * table_.masses.col(g);
        Index best = old;
        for (Index c = 0; c < costs.size(); ++c) {
            if (options_.allowed[static_cast<std::size_t>(c)] && costs[c] < costs[best]) best = c;
        }
        if (!options_.allowed[static_cast<std::size_t>(old)] && best == old) {
            double least = std::numeric_limits<double>::infinity();
            for (Index c = 0; c < costs.size(); ++c) {
                if (options_.allowed[static_cast<std::size_t>(c)] && costs[c] < least) {
                    least = costs[c];
                    best = c;
                }
            }
        }
        residual += responses.col(best);
        choice.columns[group] = static_cast<std::size_t>(best);
        return best != old;
    }

    void step_factors(Choice& choice, VectorXd& residual) const {
        if (choice.steps.size() == 0) return;
        const VectorXd wanted =
            choice.steps - VectorXd(table_.largest_steps.cwiseProduct(decomposition_.solve(residual)));
        const VectorXd bounded = wanted.cwiseMin(table_.largest_steps).cwiseMax(-table_.largest_steps);
        residual += table_.by_unknowns * (bounded - choice.steps);
        choice.steps = bounded;
    }

    const SwapTable& table_;
    const SweepOptions& options_;
    MatrixXd squares_;
    StepDecomposition decomposition_;
    MatrixXd unknowns_;  ///< an orthonormal basis of by_unknowns
    mutable long scored_ = 0;
};

/// The best of several orders under these prices.
Choice best_of_orders(const Sweeper& sweeper, const std::vector<std::size_t>& start,
                      const SweepOptions& options, const Prices& prices) {
    Choice best;
    best.objective = std::numeric_limits<double>::infinity();
    const auto cost = [&](const Choice& choice) {
        return choice.objective + prices.energy * choice.energy + prices.mass * sweeper.mass(choice);
    };
    for (int order = 0; order < options.orders; ++order) {
        Choice choice = sweeper.run(start, prices, options.seed + static_cast<std::uint64_t>(order));
        if (order == 0 || cost(choice) < cost(best)) best = std::move(choice);
    }
    return best;
}

/// The choice at the least price at which it is within a limit, by bisection of the logarithm of the price.
/// If no price helps, the choice at the highest price.
template <class Try>
Choice at_least_price(double highest, const Try& attempt) {
    auto [free, is_free_within] = attempt(0.0);
    if (is_free_within) return free;
    double low = std::log(highest) - 40.0;
    double high = std::log(highest);
    auto [best, is_within] = attempt(highest);
    for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (low + high);
        auto [choice, is_choice_within] = attempt(std::exp(middle));
        (is_choice_within ? high : low) = middle;
        if (is_choice_within) best = std::move(choice);
    }
    return best;
}

Choice within_radius(const Sweeper& sweeper, const SwapTable& table, const std::vector<std::size_t>& start,
                     const SweepOptions& options, double mass_price) {
    const double most = options.radius * table.energy;
    const double scale = (table.residual.squaredNorm() + 1e-300) / std::max(table.energy, 1e-300);
    double best_price = 1e6 * scale;
    Choice found = at_least_price(1e6 * scale, [&](double price) {
        Choice choice = sweeper.run(start, {price, mass_price}, options.seed);
        const bool is_within = choice.energy <= most;
        if (is_within) best_price = std::min(best_price, price);
        return std::pair(std::move(choice), is_within);
    });
    if (mass_price > 0.0) return found;
    const auto take_better = [&](Choice&& other) {
        if (other.energy <= most && other.objective < found.objective) found = std::move(other);
    };
    take_better(best_of_orders(sweeper, start, options, {best_price, 0.0}));
    if (options.proposals > 0) take_better(sweeper.anneal(found, most));
    return found;
}

struct OneSwap {
    std::size_t group = 0;
    std::size_t column = 0;
    VectorXd change;
    double energy = 0.0;
};

std::vector<OneSwap> single_swaps(const SwapTable& table, const std::vector<std::size_t>& start,
                                  const std::vector<bool>& allowed) {
    std::vector<OneSwap> swaps;
    for (std::size_t g = 0; g < start.size(); ++g) {
        const VectorXd own = table.responses[g].col(static_cast<Index>(start[g]));
        for (std::size_t c = 0; c < table.columns(); ++c) {
            const auto column = static_cast<Index>(c);
            if (allowed[c] && c != start[g])
                swaps.push_back({g, c, table.responses[g].col(column) - own,
                                 table.energies(column, static_cast<Index>(g))});
        }
    }
    return swaps;
}

VectorXd residual_of(const SwapTable& table, const std::vector<std::size_t>& start) {
    VectorXd residual = table.residual;
    for (std::size_t g = 0; g < start.size(); ++g)
        residual += table.responses[g].col(static_cast<Index>(start[g]));
    return residual;
}

void keep_best(std::vector<Choice>& choices, std::size_t count) {
    std::ranges::stable_sort(choices, {}, &Choice::objective);
    if (choices.size() > count)
        choices.erase(choices.begin() + static_cast<std::ptrdiff_t>(count), choices.end());
}

}  // namespace

MatrixXd unknown_basis(const SwapTable& table) {
    if (table.by_unknowns.cols() == 0) return {};
    return basis_of(step_decomposition_of(table), table.by_unknowns.rows());
}

MatrixXd left_by_unknowns(const MatrixXd& basis, const MatrixXd& residuals) {
    if (basis.cols() == 0) return residuals;
    return residuals - basis * (basis.transpose() * residuals);
}

VectorXd best_steps(const SwapTable& table, const VectorXd& residual) {
    if (table.by_unknowns.cols() == 0) return VectorXd();
    const VectorXd shares = -step_decomposition_of(table).solve(residual);
    return table.largest_steps.cwiseProduct(shares.cwiseMin(1.0).cwiseMax(-1.0));
}

Choice sweep(const SwapTable& table, const std::vector<std::size_t>& start, const SweepOptions& options) {
    const Sweeper sweeper(table, options);
    Choice found;
    if (options.most_mass <= 0.0) {
        found = within_radius(sweeper, table, start, options, 0.0);
    } else {
        const double scale = (table.residual.squaredNorm() + 1e-300) / options.most_mass;
        found = at_least_price(1e4 * scale, [&](double price) {
            Choice choice = within_radius(sweeper, table, start, options, price);
            const bool is_within = sweeper.mass(choice) <= options.most_mass;
            return std::pair(std::move(choice), is_within);
        });
    }
    found.scored = sweeper.scored();
    return found;
}

std::vector<Choice> neighbours(const SwapTable& table, const std::vector<std::size_t>& start,
                               const std::vector<bool>& allowed, std::size_t count,
                               const base::Control& control) {
    const std::vector<OneSwap> swaps = single_swaps(table, start, allowed);
    const VectorXd residual = residual_of(table, start);
    std::vector<Choice> singles;
    std::vector<Choice> pairs;
    for (std::size_t i = 0; i < swaps.size(); ++i) {
        control.check();
        Choice single{start, VectorXd::Zero(table.by_unknowns.cols())};
        single.columns[swaps[i].group] = swaps[i].column;
        const VectorXd left = residual + swaps[i].change;
        single.objective = table.unreached + left.squaredNorm();
        single.energy = swaps[i].energy;
        for (std::size_t j = i + 1; j < swaps.size(); ++j) {
            if (swaps[i].group == swaps[j].group) continue;
            Choice pair = single;
            pair.columns[swaps[j].group] = swaps[j].column;
            pair.objective = table.unreached + (left + swaps[j].change).squaredNorm();
            pair.energy += swaps[j].energy;
            pairs.push_back(std::move(pair));
        }
        singles.push_back(std::move(single));
    }
    keep_best(singles, count);
    keep_best(pairs, count);
    std::ranges::move(pairs, std::back_inserter(singles));
    return singles;
}

std::vector<bool> fewer_columns(const SwapTable& table, const std::vector<std::size_t>& start,
                                SweepOptions options, std::size_t most) {
    options.orders = 1;
    options.proposals = 0;
    const auto used_by = [&](const Choice& choice) {
        std::vector<bool> used(table.columns(), false);
        for (const std::size_t column : choice.columns) used[column] = true;
        return used;
    };
    Choice choice = sweep(table, start, options);
    options.allowed = used_by(choice);
    while (static_cast<std::size_t>(std::ranges::count(options.allowed, true)) > most) {
        std::vector<std::size_t> counts(table.columns(), 0);
        for (const std::size_t column : choice.columns) ++counts[column];
        // Only the columns that are used least are tried; the others are usually of more use.
        constexpr std::size_t kTried = 6;
        std::vector<std::size_t> candidates;
        for (std::size_t c = 0; c < counts.size(); ++c) {
            if (options.allowed[c]) candidates.push_back(c);
        }
        std::ranges::stable_sort(candidates, {}, [&](std::size_t c) { return counts[c]; });
        candidates.resize(std::min(candidates.size(), kTried));
        Choice best;
        best.objective = std::numeric_limits<double>::infinity();
        for (const std::size_t given_up : candidates) {
            SweepOptions without = options;
            without.allowed[given_up] = false;
            Choice found = sweep(table, choice.columns, without);
            if (found.objective < best.objective) best = std::move(found);
        }
        choice = std::move(best);
        options.allowed = used_by(choice);
    }
    return options.allowed;
}

}  // namespace fretwork::design::detail

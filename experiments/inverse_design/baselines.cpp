// SPDX-License-Identifier: GPL-3.0-or-later
#include "baselines.hpp"

#include <fretwork/base/random.hpp>
#include <fretwork/optimization/methods/pagmo_methods.hpp>
#include <fretwork/optimization/minimize.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace fretwork::experiments {

using design::detail::Point;
using design::detail::SwapTable;
using design::detail::Trial;
using design::detail::Trials;

Baseline random_paintings(Trials& trials, int solutions, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    Baseline best{{}, std::numeric_limits<double>::infinity()};
    const std::size_t patterns = trials.parts().candidates.patterns().size();
    for (const int end = trials.solutions() + solutions; trials.solutions() < end;) {
        Point point = trials.uniform(0);
        for (std::size_t& pattern : point.patterns) pattern = random.below(patterns);
        const Trial trial = trials.solve(point, {});
        if (trial.is_found && trial.objective < best.objective) best = {point, trial.objective};
    }
    return best;
}

Baseline greedy_swaps(Trials& trials, const Point& start, int solutions) {
    std::vector<std::size_t> columns(trials.parts().candidates.patterns().size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    Point point = start;
    const int end = trials.solutions() + solutions;
    Trial trial = trials.solve(point, {});
    long swaps = 0;
    while (trials.solutions() < end) {
        const SwapTable table = trials.table(point, trial, columns, 1, {});
        swaps += static_cast<long>(table.groups() * table.columns());
        double best = table.residual.squaredNorm();
        Point next = point;
        for (std::size_t g = 0; g < table.groups(); ++g) {
            for (std::size_t c = 0; c < columns.size(); ++c) {
                const double found =
                    (table.residual + table.responses[g].col(static_cast<Eigen::Index>(c))).squaredNorm();
                if (found >= best) continue;
                best = found;
                next = point;
                next.patterns[g] = columns[c];
            }
        }
        if (next == point) break;
        Trial swapped = trials.solve(next, {});
        if (!swapped.is_found || swapped.objective >= trial.objective) break;
        point = std::move(next);
        trial = std::move(swapped);
    }
    return {point, trial.objective, swaps};
}

Baseline annealing(Trials& trials, const Point& start, int solutions, std::uint64_t seed) {
    base::SplitMix64 random(seed);
    const std::size_t patterns = trials.parts().candidates.patterns().size();
    const int begin = trials.solutions();
    Point point = start;
    double objective = trials.solve(point, {}).objective;
    Baseline best{point, objective};
    const double first = 0.1 * objective;
    while (trials.solutions() < begin + solutions) {
        const double share = static_cast<double>(trials.solutions() - begin) / solutions;
        const double temperature = first * std::pow(1e-4, share);
        Point next = point;
        next.patterns[random.below(next.patterns.size())] = random.below(patterns);
        const Trial trial = trials.solve(next, {});
        if (!trial.is_found) continue;
        if (trial.objective > objective &&
            random.share() >= std::exp((objective - trial.objective) / temperature))
            continue;
        point = std::move(next);
        objective = trial.objective;
        if (objective < best.objective) best = {point, objective};
    }
    return best;
}

namespace {

constexpr double kFirstRadius = 0.5;

/// Anneals on a table of superposed answers, inside of a trust region on the energy of the change.
class TableAnnealing {
  public:
    TableAnnealing(const SwapTable& table, const std::vector<std::size_t>& start, double most_energy)
        : table_(table), columns_(start), residual_(table.residual), most_energy_(most_energy) {
        for (std::size_t g = 0; g < start.size(); ++g) residual_ += response(g, start[g]);
    }
    void propose(base::SplitMix64& random, double temperature) {
        const std::size_t group = random.below(table_.groups());
        const std::size_t column = random.below(table_.columns());
        const Eigen::VectorXd change = response(group, column) - response(group, columns_[group]);
        const double more = 2.0 * residual_.dot(change) + change.squaredNorm();
        const double energy = energy_ + this->energy(group, column) - this->energy(group, columns_[group]);
        if (energy > most_energy_) return;
        if (more > 0.0 && random.share() >= std::exp(-more / temperature)) return;
        residual_ += change;
        energy_ = energy;
        columns_[group] = column;
    }
    [[nodiscard]] const std::vector<std::size_t>& columns() const { return columns_; }

  private:
    [[nodiscard]] Eigen::VectorXd response(std::size_t group, std::size_t column) const {
        return table_.responses[group].col(static_cast<Eigen::Index>(column));
    }
    [[nodiscard]] double energy(std::size_t group, std::size_t column) const {
        return table_.energies(static_cast<Eigen::Index>(column), static_cast<Eigen::Index>(group));
    }

    const SwapTable& table_;
    std::vector<std::size_t> columns_;
    Eigen::VectorXd residual_;
    double most_energy_;
    double energy_ = 0.0;
};

/// Solves one painting after the other: each number is a place among the patterns from soft to stiff.
class GradedPaintings : public optimization::Problem {
  public:
    GradedPaintings(Trials& trials, const std::vector<std::size_t>& order) : trials_(trials), order_(order) {
        const auto groups = static_cast<Eigen::Index>(trials.parts().groups.size());
        bounds_.lower = Eigen::VectorXd::Zero(groups);
        bounds_.upper = Eigen::VectorXd::Ones(groups);
    }
    [[nodiscard]] std::string name() const override { return "graded paintings"; }
    [[nodiscard]] const optimization::Bounds& bounds() const override { return bounds_; }
    [[nodiscard]] double value(const Eigen::VectorXd& point) const override {
        const Trial trial = trials_.solve(painting(point), {});
        return trial.is_found ? trial.objective : std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] Point painting(const Eigen::VectorXd& point) const {
        Point result = trials_.uniform(0);
        for (std::size_t g = 0; g < result.patterns.size(); ++g) {
            const double place = point[static_cast<Eigen::Index>(g)] * static_cast<double>(order_.size());
            result.patterns[g] = order_[std::min(order_.size() - 1, static_cast<std::size_t>(place))];
        }
        return result;
    }

  private:
    Trials& trials_;
    const std::vector<std::size_t>& order_;
    optimization::Bounds bounds_;
};

}  // namespace

Baseline table_annealing(Trials& trials, const Point& start, const Work& work, std::uint64_t seed) {
    std::vector<std::size_t> columns(trials.parts().candidates.patterns().size());
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    base::SplitMix64 random(seed);
    const int end = trials.solutions() + work.solutions;
    const long share = work.swaps / std::max(1, work.solutions);
    Point point = start;
    std::optional<SwapTable> table;  // of the point
    double radius = kFirstRadius;
    Trial trial = trials.solve(point, {});
    double objective = trial.objective;
    while (trials.solutions() < end) {
        if (!table) table = trials.table(point, trial, columns, seed, {});
        TableAnnealing annealing(*table, point.patterns, radius * table->energy);
        for (long i = 0; i < share; ++i) {
            const double done = static_cast<double>(i) / static_cast<double>(share);
            annealing.propose(random, 0.1 * objective * std::pow(1e-4, done));
        }
        Point next = point;
        next.patterns = annealing.columns();
        trial = trials.solve(next, {});
        if (trial.is_found && trial.objective < objective) {
            point = std::move(next);
            objective = trial.objective;
            table.reset();
            radius = std::min(4.0, 2.0 * radius);
        } else {
            radius = radius < 1e-4 ? kFirstRadius : 0.25 * radius;
        }
    }
    return {point, objective, share * work.solutions};
}

Baseline cma_es(Trials& trials, const std::vector<std::size_t>& order, int solutions, std::uint64_t seed) {
    const GradedPaintings problem(trials, order);
    optimization::PagmoOptions options;
    options.common = {.starts = 1, .seed = seed};
    const auto report =
        optimization::minimize(problem, *optimization::make_cma_es(options), {.cost = solutions});
    return {problem.painting(report.point), report.value};
}

}  // namespace fretwork::experiments

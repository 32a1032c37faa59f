// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace fretwork::design::detail {

/// A clock with a time limit for the search.
class Stopwatch {
  public:
    explicit Stopwatch(double limit) : limit_(limit) {}
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    }
    /// True if at least `needed` seconds of the limit are left, or there is no limit.
    [[nodiscard]] bool has_left(double needed) const { return limit_ <= 0.0 || seconds() + needed < limit_; }

  private:
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
    double limit_;
};

/// A point of the search space, and its solution.
struct Solved {
    Point point;
    Trial trial;
};

/// The largest number of nonlinear solutions of a search over `groups` groups; see
/// DesignOptions::most_solutions.
int solution_limit(const DesignOptions& options, std::size_t groups);

/// The search for a painting with the reduced model.
class Search {
  public:
    Search(Trials& trials, const DesignOptions& options, const Stopwatch& watch, DesignReport& report);

    /// Solve up to DesignOptions::uniform_paintings uniform paintings. The first of them have the first
    /// members of the palette, which are the most different; from their solutions, the members are predicted
    /// that are tried next. Returns the solved paintings, the best first; paintings without a stable
    /// equilibrium are left out.
    /// @param coordinates  Preparation::coordinates
    std::vector<Solved> try_uniform(const std::vector<std::size_t>& palette,
                                    const Eigen::MatrixXd& coordinates);
    /// Improve a painting until no swap is predicted to improve its mean square distance by a share of
    /// kLeastGain, or until only `reserve` (s) of the time is left. Returns the best point found.
    Solved improve(Solved start, double reserve);
    /// Improve other starts, and the best painting with some of its tiles painted at random, until only
    /// `left` solutions are left, or only `reserve` (s) of the time. Returns the best point found.
    Solved improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve, int left);
    /// The number of solutions that are left for the defect correction.
    [[nodiscard]] int left_for_defect() const;
    /// Set the patterns from which steps choose.
    void set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all);

    [[nodiscard]] DesignEnd end() const { return end_; }
    /// The best point among all points solved since the search began, or since forget_best() was called.
    [[nodiscard]] const std::optional<Point>& best_point() const { return best_point_; }
    /// Forget the best point, which need not be the best after a change of the aims.
    void forget_best() {
        best_ = -1.0;
        best_point_.reset();
        seen_.clear();
    }
    [[nodiscard]] bool may_go_on(double reserve) const;
    /// The largest number of nonlinear solutions, granted solutions included.
    [[nodiscard]] int most_solutions() const { return most_solutions_; }
    /// Increase the largest number of nonlinear solutions.
    void grant(int solutions) { most_solutions_ += solutions; }
    /// Add a solved point to the history if it is the best so far.
    void note(const Solved& solved);

  private:
    void try_one_uniform(std::size_t pattern, std::vector<Solved>& found);
    [[nodiscard]] std::size_t predicted_best(const std::vector<Solved>& found,
                                             const std::vector<std::size_t>& palette,
                                             const Eigen::MatrixXd& coordinates,
                                             const std::vector<bool>& is_tried) const;
    [[nodiscard]] std::vector<std::size_t> columns_for(const Point& point, int round) const;
    [[nodiscard]] std::vector<bool> allowed_of(const std::vector<std::size_t>& columns) const;
    [[nodiscard]] Point kicked(const Point& point, double share, std::uint64_t number) const;
    /// The improvement that a descent must promise to continue.
    struct Demand {
        double gain = 0.0;   ///< smallest predicted gain, as a share of the misfit
        double rival = 0.0;  ///< misfit that the descent must beat; 0: none
    };
    enum class Step { Better, NoBetter, Hopeless };
    /// Take one step. Hopeless means that the misfit which the step promises is far above Demand::rival.
    Step step(Solved& current, double& radius, int round, const Demand& demand);
    Solved descend(Solved start, double reserve, const Demand& demand);
    [[nodiscard]] bool is_seen(const Point& point) const;
    Trial solve(const Point& point);
    [[nodiscard]] bool is_small() const;
    /// Solve changes of one group and of two groups, on small surfaces only. The changes that are predicted
    /// to be the best come first, and the search continues from each that is better.
    Solved try_neighbours(Solved best, double reserve, int last_solution);
    [[nodiscard]] double mass_for_groups(const Point& point, const SwapTable& table,
                                         const std::vector<std::size_t>& start) const;
    void limit_patterns(const Point& point, const SwapTable& table, const std::vector<std::size_t>& start,
                        const std::vector<std::size_t>& columns);

    Trials& trials_;
    const DesignOptions& options_;
    const Stopwatch& watch_;
    DesignReport& report_;
    std::vector<std::size_t> shortlist_;
    std::vector<std::size_t> all_;
    std::vector<std::size_t> limited_;  ///< patterns that may be used; empty: these are not chosen yet, or
                                        ///< there is no limit on their number
    double best_ = -1.0;                ///< objective of the best point; below zero: none
    std::optional<Point> best_point_;
    DesignEnd end_ = DesignEnd::NoSwapImproves;
    std::map<std::vector<std::size_t>, double> seen_;  ///< misfits of paintings, without further unknowns
    int most_solutions_;
    std::uint64_t kicks_ = 0;    ///< number of starts that were kicked so far
    double step_seconds_ = 0.0;  ///< time of the longest step so far; the next may take as long
};

}  // namespace fretwork::design::detail

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

/// Objectives (squares of shares) below this are rounding of the reduced model.
inline constexpr double kReachedObjective = 1e-14;

/// The index of each pattern in the columns. Pre: the columns are sorted and have all these patterns.
std::vector<std::size_t> places_of(const std::vector<std::size_t>& patterns,
                                   const std::vector<std::size_t>& columns);
/// The point with the patterns of a choice.
Point painted(Point point, const Choice& choice, const std::vector<std::size_t>& columns);

/// The search for a painting with the reduced model.
class Search {
  public:
    Search(Trials& trials, const DesignOptions& options, const Stopwatch& watch, DesignReport& report);

    /// The first paintings of a design.
    struct Beginning {
        std::vector<Solved> uniform;    ///< uniform paintings that were solved
        std::optional<Solved> painted;  ///< better painting than these
    };
    /// Make a first painting quickly: solve uniform paintings of the palette's first members, and improve the
    /// best one by few steps.
    Beginning begin(const std::vector<std::size_t>& palette);
    /// Solve up to DesignOptions::uniform_paintings uniform paintings. The first ones have the palette's
    /// first members, which are the most different. Their solutions predict the next members to try. Returns
    /// the solved paintings, the best first, without those that have no stable equilibrium.
    /// @param coordinates  Preparation::coordinates
    /// @param found  uniform paintings that are solved already
    std::vector<Solved> try_uniform(const std::vector<std::size_t>& palette,
                                    const Eigen::MatrixXd& coordinates, std::vector<Solved> found = {});
    /// Improve a painting until no swap is predicted to reduce its mean square distance by a share of
    /// kLeastGain, or until only `reserve` (s) of the time is left. Returns the best point found.
    Solved improve(Solved start, double reserve);
    /// Improve other starts, and the best painting with some tiles painted at random, until only `left`
    /// solutions or `reserve` (s) of the time are left. Returns the best point found.
    Solved improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve, int left);
    /// The misfit around a point that relaxed_choice() predicts for mixtures of the shortlist's patterns in
    /// each group. Pre: the last trial was that of the point.
    [[nodiscard]] double relaxed_misfit(const Solved& solved);
    /// The number of solutions that are left for the defect correction.
    [[nodiscard]] int left_for_defect() const;
    /// Set the patterns that steps consider.
    void set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all);

    [[nodiscard]] DesignEnd end() const { return end_; }
    /// The best point among all points solved since the search began, or since forget_best() was called.
    [[nodiscard]] const std::optional<Point>& best_point() const { return best_point_; }
    /// Forget the best point, because the aims have changed.
    void forget_best() {
        best_ = -1.0;
        best_point_.reset();
        seen_.clear();
    }
    [[nodiscard]] bool may_go_on(double reserve) const;
    /// True if enough solutions are left for one more point, with one for each load case.
    [[nodiscard]] bool may_solve() const;
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
    /// The conditions for continuing a descent.
    struct Demand {
        double gain = 0.0;   ///< smallest predicted gain, as a share of the misfit
        double rival = 0.0;  ///< misfit that the descent must beat; 0: none
    };
    enum class Step { Better, NoBetter, Hopeless };
    /// Take one step. Hopeless: the predicted misfit is far above Demand::rival.
    Step step(Solved& current, double& radius, int round, const Demand& demand);
    Solved descend(Solved start, double reserve, const Demand& demand);
    [[nodiscard]] bool is_seen(const Point& point) const;
    Trial solve(const Point& point);
    [[nodiscard]] bool is_small() const;
    /// True if all paintings can be ranked by a table of pairs.
    [[nodiscard]] bool can_rank_all() const;
    /// On small surfaces, solve the paintings that a table at the best painting ranks first, and continue
    /// from each better one. The table ranks all paintings if can_rank_all(), and otherwise those that differ
    /// in one or two groups.
    Solved search_nearby(Solved best, double reserve, int last_solution);
    std::vector<Point> promising(Solved& best);
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
    /// Patterns that may be used; empty: not chosen yet, or no limit on their number.
    std::vector<std::size_t> limited_;
    double best_ = -1.0;  ///< objective of the best point; below zero: none
    std::optional<Point> best_point_;
    DesignEnd end_ = DesignEnd::NoSwapImproves;
    std::map<std::vector<std::size_t>, double> seen_;  ///< misfits of paintings, without further unknowns
    int most_solutions_;
    std::uint64_t kicks_ = 0;    ///< number of starts with random tiles so far
    double step_seconds_ = 0.0;  ///< time of the longest step so far: an estimate for the next
};

}  // namespace fretwork::design::detail

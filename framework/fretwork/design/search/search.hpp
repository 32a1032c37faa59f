// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/stopwatch.hpp>
#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace fretwork::design::detail {

/// A clock with a time limit for the search.
class TimeLimit {
  public:
    explicit TimeLimit(double limit) : limit_(limit) {}
    /// The time since the clock was made, s.
    [[nodiscard]] double seconds() const { return watch_.seconds(); }
    /// True if there is no limit, or if more than `needed` seconds are left.
    [[nodiscard]] bool has_left(double needed) const { return limit_ <= 0.0 || seconds() + needed < limit_; }

  private:
    base::Stopwatch watch_;
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

/// An objective (the squared misfit) below this is rounding of the reduced model: the target is reached.
inline constexpr double kReachedObjective = 1e-14;

/// For each pattern, its index in `columns`. Pre: `columns` is sorted and has all of `patterns`.
std::vector<std::size_t> places_of(const std::vector<std::size_t>& patterns,
                                   const std::vector<std::size_t>& columns);
/// The point with the patterns of a choice, but without its steps.
Point painted(Point point, const Choice& choice, const std::vector<std::size_t>& columns);

/// The search for a painting with the reduced model.
class Search {
  public:
    Search(Trials& trials, const DesignOptions& options, const TimeLimit& time, DesignReport& report);

    /// The first paintings of a design.
    struct Beginning {
        std::vector<Solved> uniform;    ///< uniform paintings that were solved
        std::optional<Solved> painted;  ///< a painting better than all of these; none: not found
    };
    /// Make a first painting quickly: solve uniform paintings with the palette's first patterns, and improve
    /// the best of them by a few steps.
    Beginning begin(const std::vector<std::size_t>& palette);
    /// Solve up to DesignOptions::uniform_paintings uniform paintings. The first ones have the palette's
    /// first patterns, which are the most different. Their solutions predict which patterns to try next.
    /// With a time limit, no further painting is tried once one is found and 30 % of the time is used.
    /// Returns the solved paintings that have a stable equilibrium, the best first. With
    /// DesignOptions::max_mass, those that keep it come before all others.
    /// @param coordinates  Preparation::coordinates
    /// @param found  uniform paintings that are solved already
    std::vector<Solved> try_uniform(const std::vector<std::size_t>& palette,
                                    const Eigen::MatrixXd& coordinates, std::vector<Solved> found = {});
    /// Improve a painting until no step is predicted to gain 0.5 % of the objective, until no solution
    /// confirms a predicted gain, until the target is reached (kReachedObjective), or until the solutions or
    /// the time (but for `reserve` seconds) are used up. Returns the best point found.
    Solved improve(Solved start, double reserve);
    /// Continue the search from the second and the third of `starts`, then from copies of the best painting
    /// with some or all tiles painted at random; on small surfaces, search_nearby() follows each better
    /// painting. Begin from no other start when only `left` solutions are left; a search that has begun may
    /// use these. Stop when only `reserve` seconds are left. Returns the best point found.
    Solved improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve, int left);
    /// The misfit that relaxed_choice() predicts near a point if each group could have a mixture of the
    /// patterns of the shortlist and of the painting, or of those that DesignOptions::max_patterns has left.
    /// Pre: the point was solved last.
    [[nodiscard]] double relaxed_misfit(const Solved& solved);
    /// The number of solutions for the defect correction (README.md, step 8): with no more left, the search
    /// begins from no other start.
    [[nodiscard]] int left_for_defect() const;
    /// Set the patterns that steps consider besides those of the painting: the first and every second step
    /// takes `shortlist`, and each step between draws as many from `all` at random.
    void set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all);

    /// The reason why the last improve() ended.
    [[nodiscard]] DesignEnd end() const { return end_; }
    /// The best point that note() has taken since the last begin_at(), if any.
    [[nodiscard]] const std::optional<Point>& best_point() const { return best_point_; }
    /// Forget the objectives of solved paintings. Called after Trials::set_aims(), which changes all of them,
    /// and before begin_at().
    void forget_solved() { seen_.clear(); }
    /// True if solutions and time for one more step are left, but for `reserve` seconds.
    [[nodiscard]] bool may_go_on(double reserve) const;
    /// True if enough solutions are left for one more point. A point takes one solution for each load case.
    [[nodiscard]] bool may_solve() const;
    /// The largest number of nonlinear solutions, with those added by grant().
    [[nodiscard]] int most_solutions() const { return most_solutions_; }
    /// Increase the largest number of nonlinear solutions.
    void grant(int solutions) { most_solutions_ += solutions; }
    /// Add a solved point to the history, and call DesignOptions::on_better, if the point is the best so far
    /// and keeps DesignOptions::max_mass.
    void note(const Solved& solved);
    /// Let note() take only points that are better than the start of a search, or any point if the start is
    /// above DesignOptions::max_mass.
    void begin_at(const Solved& start);

    /// True if a painting keeps DesignOptions::max_mass, or if there is no such limit.
    [[nodiscard]] bool keeps_mass(const Point& point) const;
    /// True if a solved point is better than another one: it alone keeps DesignOptions::max_mass, or both or
    /// none keep it and its objective is smaller.
    [[nodiscard]] bool is_better(const Solved& own, const Solved& other) const;

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
        double gain = 0.0;   ///< smallest predicted gain, as a share of the objective
        double rival = 0.0;  ///< objective of the best painting so far, for comparison; 0: none
    };
    enum class Step { Better, NoBetter, Hopeless };
    /// Take one step. Hopeless: from the third round on, the predicted objective is more than 1.3 times
    /// Demand::rival.
    Step step(Solved& current, double& radius, int round, const Demand& demand);
    Solved descend(Solved start, double reserve, const Demand& demand);
    [[nodiscard]] bool is_seen(const Point& point) const;
    Trial solve(const Point& point);
    /// Solve a point again if another point was solved since. Returns false, and leaves the point as it was,
    /// if it is not found again: the path from another point may miss its equilibrium.
    bool return_to(Solved& solved);
    [[nodiscard]] bool is_small() const;
    /// True if all paintings can be ranked by a table of pairs.
    [[nodiscard]] bool can_rank_all() const;
    /// For small surfaces: rank paintings by a table at the best painting, solve them in this order, and
    /// begin again at each better painting. The table ranks all paintings if can_rank_all(). Otherwise, it
    /// ranks those that differ from the best in one or two groups.
    Solved search_nearby(Solved best, double reserve, int last_solution);
    /// The paintings that search_nearby() solves next; none if the best painting is not found again.
    std::vector<Point> promising(Solved& best);
    [[nodiscard]] double mass_for_groups(const Point& point, const SwapTable& table,
                                         const std::vector<std::size_t>& start) const;
    void limit_patterns(const Point& point, const SwapTable& table, const std::vector<std::size_t>& start,
                        const std::vector<std::size_t>& columns);

    Trials& trials_;
    const DesignOptions& options_;
    const TimeLimit& time_;
    DesignReport& report_;
    std::vector<std::size_t> shortlist_;
    std::vector<std::size_t> all_;
    /// Patterns that may be used under DesignOptions::max_patterns; empty: there is no limit, or they are not
    /// chosen yet.
    std::vector<std::size_t> limited_;
    double best_ = -1.0;  ///< objective of the best point; below zero: none
    std::optional<Point> best_point_;
    DesignEnd end_ = DesignEnd::NoSwapImproves;
    /// Objectives of solved paintings, if there are no continuous unknowns; infinity: no stable equilibrium.
    std::map<std::vector<std::size_t>, double> seen_;
    int most_solutions_;
    std::uint64_t kicks_ = 0;    ///< number of starts with random tiles so far
    double step_seconds_ = 0.0;  ///< time of the longest step so far: an estimate for the next
};

}  // namespace fretwork::design::detail

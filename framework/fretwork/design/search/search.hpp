// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/design.hpp>
#include <fretwork/design/search/trials.hpp>

#include <chrono>
#include <functional>
#include <optional>
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

/// A point and its solution.
struct Solved {
    Point point;
    Trial trial;
};

/// The search for a painting with the reduced model.
class Search {
  public:
    Search(Trials& trials, const DesignOptions& options, const Stopwatch& watch, DesignReport& report)
        : trials_(trials), options_(options), watch_(watch), report_(report) {}

    /// Solve the uniform painting of each of these candidates. Returns them with the best first, without
    /// those that have no stable equilibrium.
    std::vector<Solved> try_uniform(const std::vector<std::size_t>& patterns);
    /// Improve a painting until no swap improves it, or only `reserve` s are left. Returns the best point
    /// found.
    Solved improve(Solved start, double reserve);
    /// Improve other starts, and the best painting with a random part of it painted at random, until the
    /// budget is spent or only `reserve` s are left.
    Solved improve_from_others(Solved best, const std::vector<Solved>& starts, double reserve);
    /// The patterns that steps choose from.
    void set_columns(std::vector<std::size_t> shortlist, std::vector<std::size_t> all);

    [[nodiscard]] DesignEnd end() const { return end_; }
    /// The best point that was solved since the search began or forget_best() was called.
    [[nodiscard]] const std::optional<Point>& best_point() const { return best_point_; }
    /// Forget the best point: after a change of the aims it need not be the best.
    void forget_best() {
        best_ = -1.0;
        best_point_.reset();
    }
    [[nodiscard]] bool may_go_on(double reserve) const;

  private:
    [[nodiscard]] std::vector<std::size_t> columns_for(const Point& point, int round) const;
    [[nodiscard]] Point kicked(const Point& point, std::uint64_t number) const;
    /// Take one step. Returns false if no proposal is better than the current point.
    bool step(Solved& current, double& radius, int round);
    [[nodiscard]] double mass_for_groups(const Point& point, const SwapTable& table,
                                         const std::vector<std::size_t>& start) const;
    void limit_patterns(const Point& point, const SwapTable& table, const std::vector<std::size_t>& start,
                        const std::vector<std::size_t>& columns);
    void tell(const Solved& solved);

    Trials& trials_;
    const DesignOptions& options_;
    const Stopwatch& watch_;
    DesignReport& report_;
    std::vector<std::size_t> shortlist_;
    std::vector<std::size_t> all_;
    std::vector<std::size_t>
        limited_;         ///< the few patterns that may be used; empty: not chosen yet, or no limit
    double best_ = -1.0;  ///< objective; below zero: none
    std::optional<Point> best_point_;
    DesignEnd end_ = DesignEnd::NoSwapImproves;
    double step_seconds_ = 0.0;  ///< time of the longest step so far; the next may take as long
};

}  // namespace fretwork::design::detail

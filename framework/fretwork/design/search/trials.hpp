// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_model.hpp>
#include <fretwork/design/search/tile_groups.hpp>
#include <fretwork/design/swaps/swap_table.hpp>
#include <fretwork/simulation/session.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace fretwork::design::detail {

/// A load case of a design, and the goals under it.
struct DesignCase {
    simulation::LoadCase load_case;
    CaseGoals goals;
};

/// A point of the search space: a pattern for each group of tiles (its place among the candidates), and the
/// continuous unknowns. These are, for each load case, the factor on its loads and the values of its
/// prescribed displacements, if they are free; then the width and the thickness of all bars, if they are.
struct Point {
    std::vector<std::size_t> patterns;
    Eigen::VectorXd unknowns;
    friend bool operator==(const Point&, const Point&) = default;
};

/// The solution of a point.
struct Trial {
    bool is_found = false;  ///< true if all equilibria were found and are stable
    double objective =
        0.0;  ///< the weighted mean of squared distances, in shares of the largest displacement wanted
    std::vector<mechanics::NodeValues> displacements{};  ///< rows of the interface nodes, for each load case
};

/// The unknowns besides the painting that are free.
struct FreeUnknowns {
    bool factor = false;
    bool prescribed = false;
    bool width = false;
    bool thickness = false;
};

/// The input of Trials. `surface` has to be painted.
struct TrialParts {
    simulation::Surface surface;
    std::vector<DesignCase> cases;
    simulation::CandidateTiles candidates;
    std::vector<TileGroup> groups;
    std::vector<std::size_t> mirrored;  ///< the place of each candidate's mirror image; empty: none is needed
    FreeUnknowns free;
    int threads = 0;
};

/// The lightest painting.
struct Lightest {
    double mass = 0.0;        ///< kg
    std::size_t pattern = 0;  ///< the candidate that its first group has
};

/// Solves points one after the other, each from the last equilibrium, and predicts the effects of swaps
/// there.
class Trials {
  public:
    /// Throws Stopped.
    explicit Trials(TrialParts parts, const base::Control& control = {});

    [[nodiscard]] const TrialParts& parts() const { return parts_; }
    [[nodiscard]] Eigen::VectorXd initial_unknowns() const;
    [[nodiscard]] Point uniform(std::size_t pattern) const;
    /// Unknowns within their bounds: bars keep some width and thickness.
    [[nodiscard]] Eigen::VectorXd bounded(Eigen::VectorXd unknowns) const;
    /// Set the positions that are added to the wanted ones, for each load case (CaseGoals::observe).
    void set_aims(std::vector<mechanics::NodeValues> aims) { aims_ = std::move(aims); }

    /// Throws Stopped.
    Trial solve(const Point& point, const base::Control& control);
    /// Whether the last solution was that of this point, and was found.
    [[nodiscard]] bool is_at(const Point& point) const { return at_ == point; }
    /// The table of swaps at the point of the last trial, whose equilibria were found. Columns are
    /// candidates.
    SwapTable table(const Point& point, const Trial& trial, const std::vector<std::size_t>& columns,
                    std::uint64_t seed, const base::Control& control);
    /// The misfit of displacements (Trial::objective) with the goals as they are wanted, or with the moved
    /// aims.
    [[nodiscard]] double misfit(const std::vector<mechanics::NodeValues>& displacements) const {
        return objective(displacements, aims_);
    }
    [[nodiscard]] int solutions() const { return solutions_; }
    /// Count solutions that were made elsewhere.
    void count_solutions(int more) { solutions_ += more; }

    /// The surface with a point's painting, and the load cases with its unknowns.
    [[nodiscard]] simulation::Surface surface_at(const Point& point) const;
    [[nodiscard]] simulation::LoadCase load_case_at(const Point& point, std::size_t which) const;
    [[nodiscard]] reduction::Setting setting_at(const Point& point) const;
    /// The mass of all beams, kg.
    [[nodiscard]] double mass_of(const Point& point) const;
    /// The mass of the lightest painting.
    [[nodiscard]] Lightest lightest(const std::vector<std::size_t>& palette) const;
    /// The factor on the loads of a load case. Pre: the factor is free.
    [[nodiscard]] double factor_at(const Point& point, std::size_t which) const;
    /// The mean and largest distance of the goals' nodes, in shares of the largest displacement wanted.
    struct Distances {
        double mean = 0.0;
        double largest = 0.0;
    };
    [[nodiscard]] Distances distances(const std::vector<mechanics::NodeValues>& displacements) const;
    [[nodiscard]] double largest_wanted() const { return largest_; }
    /// The place of the first unknown of a load case; of the section for the number of load cases.
    [[nodiscard]] Eigen::Index first_unknown(std::size_t which) const;
    /// 1/m: from weighted distances to the misfit.
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] const TileStrains& strains() const { return strains_; }
    /// The candidates that a tile may have when groups have those of a palette.
    [[nodiscard]] std::set<std::size_t> possible(tiling::TileIndex tile,
                                                 const std::vector<std::size_t>& palette) const;
    /// The objective that a trial's displacements would have as a multiple of what they are, each load case
    /// by its own multiple.
    [[nodiscard]] double scaled_objective(const Trial& trial) const;

  private:
    [[nodiscard]] std::vector<std::size_t> painting(const Point& point) const;
    [[nodiscard]] std::size_t member_pattern(const TileGroup::Member& member, std::size_t pattern) const {
        return member.is_mirrored ? parts_.mirrored[pattern] : pattern;
    }
    /// The place of the first unknown of the bars' section.
    [[nodiscard]] Eigen::Index first_of_section() const { return first_unknown(parts_.cases.size()); }
    void paint(const std::vector<std::size_t>& painting);
    void take_setting(const reduction::Setting& setting);
    /// Condense the candidates again if the bars have changed.
    void refresh_candidates(const base::Control& control);
    void add_section(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const;
    [[nodiscard]] double objective(const std::vector<mechanics::NodeValues>& displacements,
                                   const std::vector<mechanics::NodeValues>& aims) const;
    void fill_group(std::size_t group, const std::vector<CaseModel>& models,
                    const std::vector<std::size_t>& columns, SwapTable& table) const;
    void add_unknowns(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const;

    TrialParts parts_;
    TileStrains strains_;
    reduction::Setting setting_;            ///< of the sessions
    reduction::Setting candidate_setting_;  ///< of the candidates
    std::vector<std::size_t> kept_;         ///< the candidate of each tile that belongs to no group
    std::vector<simulation::Session> sessions_;
    std::vector<std::size_t> painted_;  ///< the candidate of each tile in the sessions
    std::vector<mechanics::NodeValues> unit_loads_;
    std::vector<mechanics::NodeValues> aims_;
    double largest_ = 0.0;
    double scale_ = 0.0;
    std::optional<Point> at_;  ///< of the last solution; none if it was not found
    int solutions_ = 0;
};

/// The load case with its loads, but not the weight, multiplied by a factor.
simulation::LoadCase with_factor(simulation::LoadCase load_case, double factor);

}  // namespace fretwork::design::detail

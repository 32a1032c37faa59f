// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/design/search/case_model.hpp>
#include <fretwork/design/search/joint_swaps.hpp>
#include <fretwork/design/search/tile_groups.hpp>
#include <fretwork/design/swaps/pair_table.hpp>
#include <fretwork/design/swaps/swap_table.hpp>
#include <fretwork/simulation/session.hpp>

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fretwork::design::detail {

/// A load case of a design, and the goals under it.
struct DesignCase {
    simulation::LoadCase load_case;
    CaseGoals goals;
};

/// A point of the search space: the index of each group's pattern among the candidates, and the continuous
/// unknowns. These are, as far as they are free: for each load case, the factor on its loads and the values
/// of its prescribed displacements; then the width and the thickness of all bars.
struct Point {
    std::vector<std::size_t> patterns;
    Eigen::VectorXd unknowns;
    friend bool operator==(const Point&, const Point&) = default;
};

/// The solution of a point.
struct Trial {
    bool is_found = false;  ///< true if all equilibria were found and are stable
    /// Mean of the weighted squared distances, as shares of the largest wanted displacement; 0 unless
    /// `is_found`.
    double objective = 0.0;
    std::vector<mechanics::NodeValues> displacements{};  ///< rows of the interface nodes for each load case
};

/// The free unknowns besides the painting.
struct FreeUnknowns {
    bool factor = false;
    bool prescribed = false;
    bool width = false;
    bool thickness = false;
};

/// The input of Trials. Pre: `surface` is painted.
struct TrialParts {
    simulation::Surface surface;
    std::vector<DesignCase> cases;
    simulation::CandidateTiles candidates;
    std::vector<TileGroup> groups;
    /// Index of each candidate's mirror image among the candidates; empty: no mirror images are needed.
    std::vector<std::size_t> mirrored;
    FreeUnknowns free;
    int threads = 0;
};

/// The mass of the lightest painting, and a pattern in it.
struct Lightest {
    double mass = 0.0;        ///< mass, kg
    std::size_t pattern = 0;  ///< index of the pattern of the first group among the candidates
};

/// Solves points, each from the last equilibrium, and predicts the effects of swaps at the last equilibrium.
class Trials {
  public:
    /// Begin with the painting of the given surface. Throws InputError if a tile has a pattern that is no
    /// candidate; Stopped.
    explicit Trials(TrialParts parts, const base::Control& control = {});

    [[nodiscard]] const TrialParts& parts() const { return parts_; }
    [[nodiscard]] Eigen::VectorXd initial_unknowns() const;
    [[nodiscard]] Point uniform(std::size_t pattern) const;
    /// The index of a candidate's mirror image; the candidate's own if no mirror images are needed.
    [[nodiscard]] std::size_t image_of(std::size_t pattern) const {
        return parts_.mirrored.empty() ? pattern : parts_.mirrored[pattern];
    }
    /// The unknowns, with width and thickness moved into their bounds (kLargestSectionChange).
    [[nodiscard]] Eigen::VectorXd bounded(Eigen::VectorXd unknowns) const;
    /// Set the displacements that are added to the wanted positions, for each load case; see
    /// CaseGoals::observe().
    void set_aims(std::vector<mechanics::NodeValues> aims) { aims_ = std::move(aims); }

    /// Condense other candidates. The present candidates must come first. Throws Stopped.
    void take_candidates(std::vector<pattern::NamedPattern> candidates, std::vector<std::size_t> mirrored,
                         const base::Control& control);

    /// Solve a point. Throws Stopped.
    Trial solve(const Point& point, const base::Control& control);
    /// True if the last solution was the solution of this point, and was found.
    [[nodiscard]] bool is_at(const Point& point) const { return at_ == point; }
    /// The table of swaps at the point of the last trial. Pre: the equilibria of this trial were found.
    /// Throws Stopped.
    /// @param columns  the candidates that are the columns of the table
    SwapTable table(const Point& point, const Trial& trial, const std::vector<std::size_t>& columns,
                    std::uint64_t seed, const base::Control& control);
    /// The same table with the interactions between pairs of groups, for surfaces with few groups and
    /// columns. Throws Stopped.
    PairTable pair_table(const Point& point, const Trial& trial, const std::vector<std::size_t>& columns,
                         std::uint64_t seed, const base::Control& control);
    /// True if pair_table() with this number of columns takes no longer than about ten solutions.
    [[nodiscard]] bool has_few_pairs(std::size_t columns) const;
    /// The objective of displacements, as in Trial::objective, with the aims of set_aims(). It is the square
    /// of DesignProgress::misfit.
    [[nodiscard]] double objective_of(const std::vector<mechanics::NodeValues>& displacements) const {
        return objective(displacements, aims_);
    }
    [[nodiscard]] int solutions() const { return solutions_; }
    /// Add solutions made elsewhere to solutions().
    void count_solutions(int more) { solutions_ += more; }

    /// The surface with the painting of a point. load_case_at() and setting_at() give a load case and the
    /// setting with the unknowns of a point.
    [[nodiscard]] simulation::Surface surface_at(const Point& point) const;
    [[nodiscard]] simulation::LoadCase load_case_at(const Point& point, std::size_t which) const;
    [[nodiscard]] reduction::Setting setting_at(const Point& point) const;
    /// The mass of all beams, kg.
    [[nodiscard]] double mass_of(const Point& point) const;
    /// The lightest painting with patterns of the palette.
    [[nodiscard]] Lightest lightest(const std::vector<std::size_t>& palette) const;
    /// The factor on the loads of a load case. Pre: the factor is free.
    [[nodiscard]] double factor_at(const Point& point, std::size_t which) const;
    /// The mean and the largest distance of the goals' nodes, as shares of the largest wanted displacement.
    struct Distances {
        double mean = 0.0;
        double largest = 0.0;
    };
    [[nodiscard]] Distances distances(const std::vector<mechanics::NodeValues>& displacements) const;
    [[nodiscard]] double largest_wanted() const { return largest_; }
    /// The index of the first unknown of load case `which`. If `which` is the number of load cases, the index
    /// of the first unknown of the bars' section.
    [[nodiscard]] Eigen::Index first_unknown(std::size_t which) const;
    /// The factor from the root of the sum of weighted squared distances to the misfit, 1/m.
    [[nodiscard]] double scale() const { return scale_; }
    [[nodiscard]] const TileStrains& strains() const { return strains_; }
    /// The indices of a tile's possible candidates if groups have candidates of the palette.
    [[nodiscard]] std::set<std::size_t> possible(tiling::TileIndex tile,
                                                 const std::vector<std::size_t>& palette) const;
    /// The smallest objective of a trial, without aims, if the displacements of each load case may be
    /// multiplied by a factor of their own, at least zero.
    [[nodiscard]] double scaled_objective(const Trial& trial) const;

  private:
    [[nodiscard]] std::vector<std::size_t> painting(const Point& point) const;
    [[nodiscard]] std::size_t member_pattern(const TileGroup::Member& member, std::size_t pattern) const {
        return member.is_mirrored ? image_of(pattern) : pattern;
    }
    /// The index of the first unknown of the bars' section.
    [[nodiscard]] Eigen::Index first_of_section() const { return first_unknown(parts_.cases.size()); }
    void paint(const std::vector<std::size_t>& painting);
    void take_setting(const reduction::Setting& setting);
    /// Condense the candidates again if the bars have changed.
    void refresh_candidates(const base::Control& control);
    void condense(std::vector<pattern::NamedPattern> candidates, const base::Control& control);
    void add_section(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const;
    [[nodiscard]] double objective(const std::vector<mechanics::NodeValues>& displacements,
                                   const std::vector<mechanics::NodeValues>& aims) const;
    /// The couplings in the models of the load cases.
    enum class Between { Nothing, Tiles };
    std::vector<CaseModel> models_at(const Trial& trial, const std::vector<std::size_t>& columns,
                                     std::uint64_t seed, Between between, const base::Control& control);
    [[nodiscard]] SwapTable table_of(const std::vector<CaseModel>& models, const Point& point,
                                     const std::vector<std::size_t>& columns,
                                     const base::Control& control) const;
    /// For some groups, the index of the group and that of the pattern that it gets.
    using Choices = std::vector<std::pair<std::size_t, std::size_t>>;
    /// The mass of a group's tiles with a pattern, kg.
    [[nodiscard]] double group_mass(std::size_t group, std::size_t pattern) const;
    /// The swaps in the tiles whose painted patterns differ from those of the choices.
    [[nodiscard]] std::vector<TileSwap> swaps_of(const Choices& choices) const;
    /// The effect on all load cases if groups get other patterns at once.
    [[nodiscard]] JointAnswer joint_response(const std::vector<CaseModel>& models,
                                             const Choices& choices) const;
    /// The same for one group, with the effects of its tiles added.
    [[nodiscard]] JointAnswer added_response(const std::vector<CaseModel>& models, std::size_t group,
                                             std::size_t pattern) const;
    void fill_group(std::size_t group, const std::vector<CaseModel>& models,
                    const std::vector<std::size_t>& columns, SwapTable& table) const;
    void add_unknowns(const std::vector<CaseModel>& models, const Point& point, SwapTable& table) const;

    TrialParts parts_;
    TileStrains strains_;
    reduction::Setting setting_;            ///< setting of the sessions
    reduction::Setting candidate_setting_;  ///< setting of the candidates
    std::vector<std::size_t> kept_;  ///< candidate of each tile in the given painting, for tiles in no group
    std::vector<simulation::Session> sessions_;
    std::vector<std::size_t> painted_;  ///< candidate of each tile in the sessions
    std::vector<mechanics::NodeValues> unit_loads_;
    std::vector<mechanics::NodeValues> aims_;
    double largest_ = 0.0;
    double scale_ = 0.0;
    std::optional<Point> at_;  ///< point of the last solution; none if the solution was not found
    int solutions_ = 0;
};

/// The load case with its loads multiplied by a factor; the weight does not change.
simulation::LoadCase with_factor(simulation::LoadCase load_case, double factor);

}  // namespace fretwork::design::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/design/design_warning.hpp>
#include <fretwork/design/gamut.hpp>
#include <fretwork/design/symmetry.hpp>
#include <fretwork/design/target/target.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/mechanics/frame/frame.hpp>
#include <fretwork/simulation/project/project.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::design {

/// The best painting so far, while the search goes on.
struct DesignProgress {
    int solutions = 0;     ///< number of nonlinear solutions so far
    int most = 0;          ///< largest number of nonlinear solutions of the search
    double seconds = 0.0;  ///< time since the search began, s
    /// Misfit of the reduced model: the root of the weighted mean square distance to the target, as a share
    /// of the largest wanted displacement.
    double misfit = 0.0;
};

/// Options of design().
struct DesignOptions {
    std::string load_case;  ///< name of the project's load case for goals without a load case
    std::vector<pattern::NamedPattern> palette;  ///< patterns to choose from
    std::size_t max_patterns =
        0;  ///< largest number of different patterns of the surface, kept tiles included; 0: any number
    std::vector<tiling::TileIndex> keep;  ///< tiles that keep their patterns
    Symmetry symmetry;                    ///< symmetry that the painting must have
    double max_mass = 0.0;                ///< largest mass of all beams, kg; 0: any mass
    /// Largest utilization of the setting's strength, checked with all beams; 0: any utilization. The
    /// largest utilization plus DesignReport::utilization_error must not exceed it.
    double max_utilization = 0.0;
    bool free_factor = false;  ///< true: the factor on each load case's loads is searched, too
    /// True: the values of each load case's prescribed displacements are searched, too.
    bool free_prescribed = false;
    /// True: the width of all bars, which must be rectangular, is searched, too.
    bool free_width = false;
    /// True: the thickness of all bars, which must be rectangular, is searched, too.
    bool free_thickness = false;
    /// The smallest gap between bars, m. Patterns with a smaller gap between their own bars are left out, and
    /// the result is the best checked painting without a smaller gap. None: any gap.
    std::optional<double> clearance{};
    double seconds = 0.0;  ///< largest wall time, checks included, s; 0: any time
    /// The largest number of nonlinear solutions of the search; checks and the fits of single patterns take
    /// further solutions. 0: the number is 40 or, if only n < 44 tiles (or groups of symmetric tiles) are
    /// painted, 40 * 44 / n, but at most 320, because the solutions of small surfaces are cheaper.
    int most_solutions = 0;
    /// The number of uniform paintings with which the search begins: two thirds have patterns of very
    /// different stiffness, and the rest are predicted from these to be the best.
    std::size_t uniform_paintings = 12;
    std::size_t shortlist = 64;  ///< number of patterns from which one step of the search chooses
    std::uint64_t seed = 1;      ///< seed of all random choices
    /// Number of threads; 0: one for each processor. The number does not change a bit of the result.
    int threads = 0;
    base::Control control{};  ///< progress and stop
    /// Called for each better painting, on the calling thread; may be empty.
    std::function<void(const DesignProgress&)> on_better{};
    /// Throws InputError if a value is invalid, or if it does not fit the project.
    void validate(const simulation::Project& project) const;
};

/// True if a largest utilization and its estimated error keep DesignOptions::max_utilization, if any. False
/// if there is such a limit and one of the two is not known.
inline bool keeps_utilization(const DesignOptions& options, const std::optional<double>& largest,
                              const std::optional<double>& error) {
    return options.max_utilization <= 0.0 ||
           (largest && error && *largest + *error <= options.max_utilization);
}

/// Distances to the target over the nodes of its goals, as shares of the largest wanted displacement. The
/// distances belong to the full model, in its nonlinear equilibrium on the stable path from flat.
struct TargetError {
    double mean = 0.0;      ///< mean distance
    double largest = 0.0;   ///< distance of the worst node
    bool is_stable = true;  ///< true if the equilibria of all load cases are stable
    /// True if the whole path from flat is stable; false if the structure snaps before.
    bool is_on_path = true;
};

/// The shape of a surface with all beams under one load case, and the wanted places of its nodes.
struct CaseShape {
    std::string load_case;  ///< name of the load case
    /// Displacements, one row for each node of the full model, interface nodes first.
    mechanics::NodeValues displacements;
    /// A node of a goal.
    struct GoalNode {
        int node = 0;  ///< index of the interface node
        /// Wanted place of the node, m; free components are the present components.
        Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
        double distance = 0.0;  ///< distance of the node from the wanted place, m
    };
    std::vector<GoalNode> goals;  ///< nodes of all goals of the load case
};

/// The reason for which the search ended.
enum class DesignEnd {
    /// No single swap is predicted to improve the painting, or no solution confirmed a predicted improvement.
    NoSwapImproves,
    SolutionsSpent,  ///< the solutions were used up
    TimeSpent,       ///< the time was used up
    Stopped,         ///< the caller stopped the search
    Unreachable      ///< no painting was searched, because none comes near the target by DesignReport::bound
};
/// The word for an end in reports.
std::string_view design_end_name(DesignEnd end);

/// The relative gain below which a gain counts as rounding or chance.
inline constexpr double kLeastDesignGain = 0.01;
/// The load is too small for a target if DesignReport::wanted_of_softest exceeds this ratio.
inline constexpr double kLoadTooSmall = 2.0;
/// The load is too large for a target if DesignReport::wanted_of_stiffest is below this ratio.
inline constexpr double kLoadTooLarge = 0.5;

/// The report of design().
struct DesignReport {
    /// Painted project; if unknowns are free, its load cases have the found values.
    simulation::Project project;
    /// Error of the painting; none if the search was stopped before the check.
    std::optional<TargetError> error;
    std::optional<TargetError> best_uniform;  ///< error of the best among the single patterns that were tried
    std::string best_uniform_pattern;         ///< id of this pattern
    std::size_t uniform_tried = 0;            ///< number of single patterns that were solved
    /// Number of solutions that the single patterns took, with their own unknowns.
    int uniform_solutions = 0;
    std::vector<std::string> patterns;  ///< patterns of the painting
    std::vector<double> factors;        ///< factor on the loads of each load case, in the order of load_cases
    std::vector<std::string> load_cases;  ///< names of the load cases
    /// Largest utilization, with all beams; none if the setting has no strength.
    std::optional<double> largest_utilization;
    /// Estimated error of `largest_utilization` by the beams' division into single elements, by a solution
    /// with two elements a beam (README.md). None unless DesignOptions::max_utilization is given, or if that
    /// solution was not found.
    std::optional<double> utilization_error{};
    /// The misfit (see DesignProgress) that mixtures of the palette's patterns in each tile are predicted to
    /// reach: a relaxed problem, linearized at the painting (README.md). A prediction, found by descent; no
    /// bound. None if the search was stopped before.
    std::optional<double> relaxed{};
    std::optional<double> width{};      ///< width of the bars, m; none if it is not free
    std::optional<double> thickness{};  ///< thickness of the bars, m; none if it is not free
    /// A lower bound of the misfit (see DesignProgress) of every painting with the palette. The bound is
    /// proven in linear theory, for targets that are small enough for this theory (README.md). None for other
    /// targets.
    std::optional<double> bound{};
    std::size_t close_bars = 0;  ///< number of pairs of bars with a gap below the clearance
    /// Warnings of the search, such as about goals that nodes cannot reach.
    std::vector<DesignWarning> warnings{};
    /// Shapes of the painting; empty if it was not checked with all beams.
    std::vector<CaseShape> shapes{};
    std::vector<CaseShape> uniform_shapes{};  ///< shapes of the best single pattern
    Gamut gamut{};                            ///< wanted curvatures and reached curvatures
    /// The largest wanted displacement, divided by the largest displacement of the softest uniform painting.
    /// A value far above one means that the load is too small for the target.
    double wanted_of_softest = 0.0;
    double wanted_of_stiffest = 0.0;  ///< the same ratio for the stiffest uniform painting
    bool nothing_moves = false;       ///< true if the load cases displace no uniform painting
    /// The largest displacement of the softest uniform painting under ten times the loads, as a share of the
    /// largest wanted displacement. None unless wanted_of_softest is above kLoadTooSmall and the load cases
    /// have loads.
    std::optional<double> reach_of_ten_loads{};
    double model_error = 0.0;  ///< mean distance between the reduced model and the full model, as a share of
                               ///< the largest wanted displacement
    std::vector<double> starts;  ///< misfit (see DesignProgress) that each start of the search reached
    std::vector<DesignProgress> history;        ///< an entry for each better painting
    DesignEnd end = DesignEnd::NoSwapImproves;  ///< the reason for which the search ended
    bool slides = false;                        ///< true if nodes may slide along a target's surface
    double seconds = 0.0;                       ///< wall time, checks included, s
    /// Number of nonlinear solutions of the search. `relaxed` takes one more.
    int solutions = 0;
    /// Number of nonlinear solutions of the checks, with all beams.
    int full_solutions = 0;
    /// Number of swaps of a pattern that were scored by superposition.
    long swaps_scored = 0;
    std::uint64_t seed = 0;  ///< seed of all random choices
    /// True if the largest utilization and its estimated error keep DesignOptions::max_utilization, if any.
    [[nodiscard]] bool keeps_utilization(const DesignOptions& options) const {
        return design::keeps_utilization(options, largest_utilization, utilization_error);
    }
    /// True if the painting's mean error is below the mean error of the best single pattern by a share of at
    /// least kLeastDesignGain, and below the largest wanted displacement. False if an error is not known.
    [[nodiscard]] bool is_better() const {
        return error && best_uniform && error->mean < (1.0 - kLeastDesignGain) * best_uniform->mean &&
               error->mean < 1.0;
    }
};

/// Paint the tiles of a project so that its surface takes the target's shape; README.md describes the method.
/// After a stop, the report has the best painting so far; a stop before the first painting throws
/// base::Stopped. Throws InputError that names an unsuitable target, palette, load case or kept tile.
DesignReport design(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design

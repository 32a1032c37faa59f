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

/// The progress of the search, reported for each better painting.
struct DesignProgress {
    int solutions = 0;     ///< number of nonlinear solutions so far
    int most = 0;          ///< largest number of nonlinear solutions of the search
    double seconds = 0.0;  ///< time since design() began, s
    /// Misfit of the reduced model: the root of the mean of the weighted squared distances to the target, as
    /// a share of the largest wanted displacement.
    double misfit = 0.0;
};

/// Options of design().
struct DesignOptions {
    std::string load_case;  ///< name of the load case for goals that name none; "": the only one
    std::vector<pattern::NamedPattern> palette;  ///< patterns to choose from, each once
    /// Largest number of different patterns of the surface, kept tiles and mirror images included; 0: any
    /// number.
    std::size_t max_patterns = 0;
    std::vector<tiling::TileIndex> keep;  ///< tiles that keep their patterns
    Symmetry symmetry;                    ///< symmetry that the painting must have
    double max_mass = 0.0;                ///< largest mass of all beams, kg; 0: any mass
    /// Limit of the utilization of the setting's strength, checked with all beams; 0: any utilization. The
    /// largest utilization plus DesignReport::utilization_error must not exceed it. The setting must have a
    /// strength.
    double max_utilization = 0.0;
    bool free_factor = false;  ///< true: the factor on each load case's loads is searched, too
    /// True: the values of each load case's prescribed displacements are searched, too.
    bool free_prescribed = false;
    /// True: the width of all bars, which must be rectangular, is searched, too.
    bool free_width = false;
    /// True: the thickness of all bars, which must be rectangular, is searched, too.
    bool free_thickness = false;
    /// The smallest gap between bars, m. Patterns with a smaller gap between their own bars are left out, and
    /// the result is the best checked painting without such gaps, if there is one. None: any gap.
    std::optional<double> clearance{};
    double seconds = 0.0;  ///< largest wall time, checks included, s; 0: any time
    /// The largest number of nonlinear solutions of the search; checks and the fits of single patterns take
    /// further solutions. 0: 40 solutions. For n < 44 tiles (or groups of symmetric tiles), solutions are
    /// cheaper, and their number is 40 * 44 / n, at most 320.
    int most_solutions = 0;
    /// The number of uniform paintings at the start of the search. The first two thirds have patterns of very
    /// different stiffness. Their solutions predict the best patterns for the last third.
    std::size_t uniform_paintings = 12;
    std::size_t shortlist = 64;  ///< number of patterns that one step of the search considers
    std::uint64_t seed = 1;      ///< seed of all random choices
    /// Number of threads; 0: one for each processor. The result is bitwise the same for every number of
    /// threads.
    int threads = 0;
    base::Control control{};  ///< progress and stop
    /// Called for each better painting, on the calling thread; may be empty.
    std::function<void(const DesignProgress&)> on_better{};
    /// Throws InputError if a value is invalid, or if it does not fit the project.
    void validate(const simulation::Project& project) const;
};

/// True if there is no DesignOptions::max_utilization, or if the largest utilization plus its estimated error
/// does not exceed it. False if there is a limit and one of the two is not known.
inline bool keeps_utilization(const DesignOptions& options, const std::optional<double>& largest,
                              const std::optional<double>& error) {
    return options.max_utilization <= 0.0 ||
           (largest && error && *largest + *error <= options.max_utilization);
}

/// Distances of the goals' nodes from their wanted positions, as shares of the largest wanted displacement.
/// The full model gives them in its nonlinear equilibrium on the path from flat; if this path does not end at
/// a stable equilibrium, on the stable branch.
struct TargetError {
    double mean = 0.0;      ///< mean distance
    double largest = 0.0;   ///< distance of the worst node
    bool is_stable = true;  ///< true if the equilibria of all load cases are stable
    /// True if the path from flat ends at a stable equilibrium in all load cases, also if stability is lost
    /// and regained on the way.
    bool is_stable_from_flat = true;
};

/// The shape of a surface under one load case, computed by the full model, and the wanted positions of the
/// goals' nodes.
struct CaseShape {
    std::string load_case;  ///< name of the load case
    /// Displacements, one row for each node of the full model, interface nodes first.
    mechanics::NodeValues displacements;
    /// A node of a goal.
    struct GoalNode {
        int node = 0;  ///< index of the interface node
        /// Wanted position, m. A free component has its present value.
        Eigen::Vector3d wanted = Eigen::Vector3d::Zero();
        double distance = 0.0;  ///< distance from the wanted position, m
    };
    std::vector<GoalNode> goals;  ///< nodes of all goals of the load case
};

/// The reason why the search ended.
enum class DesignEnd {
    /// No swaps are predicted to gain 0.5 % of the squared misfit, no solution confirmed a predicted gain, or
    /// the misfit is zero but for rounding.
    NoSwapImproves,
    SolutionsSpent,  ///< the solutions were used up
    TimeSpent,       ///< the time was used up
    Stopped,         ///< the caller stopped the search
    Unreachable      ///< no search: by DesignReport::bound, no painting comes near the target
};
/// The name of an end in reports, such as "time-spent".
std::string_view design_end_name(DesignEnd end);

/// A relative gain below this counts as rounding or chance.
inline constexpr double kLeastDesignGain = 0.01;
/// The load is too small for a target if DesignReport::wanted_of_softest exceeds this ratio.
inline constexpr double kLoadTooSmall = 2.0;
/// The load is too large for a target if DesignReport::wanted_of_stiffest is below this ratio.
inline constexpr double kLoadTooLarge = 0.5;

/// The report of design(). "Single pattern" stands for the uniform painting with one pattern of the palette.
struct DesignReport {
    /// Painted project; if unknowns are free, its load cases and its setting have the found values.
    simulation::Project project;
    /// Error of the painting; none if the search was stopped before the check, or if the check found no
    /// equilibrium.
    std::optional<TargetError> error;
    /// Error of the best single pattern among those that were checked with all beams.
    std::optional<TargetError> best_uniform;
    std::string best_uniform_pattern;  ///< id of this pattern
    std::size_t uniform_tried = 0;     ///< number of single patterns that were solved
    /// Number of nonlinear solutions before the search leaves the single patterns: for these, the fits of
    /// their unknowns, the first quick painting, and reach_of_ten_loads.
    int uniform_solutions = 0;
    std::vector<std::string> patterns;  ///< ids of the patterns of the painting, sorted
    double mass = 0.0;                  ///< mass of all beams of the painting, kg
    std::vector<double> factors;        ///< factor on the loads of each load case, in the order of load_cases
    std::vector<std::string> load_cases;  ///< names of the load cases
    /// Largest utilization, with all beams; none if the setting has no strength, or if `error` is none.
    std::optional<double> largest_utilization;
    /// Estimated discretization error of `largest_utilization`, from a solution with two elements for each
    /// beam (README.md). None without DesignOptions::max_utilization, or if that solution was not found.
    std::optional<double> utilization_error{};
    /// The predicted misfit (see DesignProgress) if each tile could have a mixture of patterns: those of the
    /// painting and of the shortlist, or those that DesignOptions::max_patterns has left. It is the solution
    /// of a relaxed problem, linearized at the painting (README.md), and no bound. None if the search was
    /// stopped, if the target is out of reach, if the time was used up, or if the painting has no stable
    /// equilibrium.
    std::optional<double> relaxed{};
    std::optional<double> width{};      ///< width of the bars, m; none if neither it nor thickness is free
    std::optional<double> thickness{};  ///< thickness of the bars, m; none if `width` is none
    /// A lower bound of the misfit (see DesignProgress) of every painting with the palette, proven in linear
    /// theory (README.md). None if displacements are too large for this theory, weight acts, supports are
    /// moved, unknowns besides the painting are free, nodes may slide along a mesh, or the surface has so
    /// many different tiles that not all patterns of the palette were condensed.
    std::optional<double> bound{};
    std::size_t close_bars = 0;  ///< number of pairs of bars with a gap below the clearance
    /// Warnings of the search, such as about goals that nodes cannot reach.
    std::vector<DesignWarning> warnings{};
    /// Shapes of the painting; empty if it was not checked with all beams.
    std::vector<CaseShape> shapes{};
    std::vector<CaseShape> uniform_shapes{};  ///< shapes of the best single pattern
    Gamut gamut{};                            ///< wanted curvatures and reached curvatures
    /// The largest wanted displacement, divided by the largest displacement of the softest uniform painting
    /// under the given loads, before any unknown is searched. A value far above one means that the load is
    /// too small for the target.
    double wanted_of_softest = 0.0;
    double wanted_of_stiffest = 0.0;  ///< the same ratio for the stiffest uniform painting
    bool nothing_moves = false;       ///< true if the load cases displace no uniform painting
    /// The largest displacement of the softest uniform painting under ten times the loads, as a share of the
    /// largest wanted displacement. Given only if wanted_of_softest is above kLoadTooSmall, the load cases
    /// have loads, neither factor nor prescribed values are free, solutions are left, and the equilibria are
    /// found.
    std::optional<double> reach_of_ten_loads{};
    /// Mean distance between the interface nodes of the reduced model and of the full model, as a share of
    /// the largest wanted displacement. 0 if no painting replaced the first checked single pattern.
    double model_error = 0.0;
    std::vector<double> start_misfits;    ///< final misfit (see DesignProgress) of each start of the search
    std::vector<DesignProgress> history;  ///< an entry for each better painting
    DesignEnd end = DesignEnd::NoSwapImproves;  ///< the reason why the search ended
    bool slides = false;                        ///< true if a goal lets nodes slide along a mesh
    double seconds = 0.0;                       ///< wall time, checks included, s
    /// Number of nonlinear solutions of the search, without those for `relaxed` (one for each load case).
    int solutions = 0;
    /// Number of nonlinear solutions of the checks, with all beams.
    int full_solutions = 0;
    /// Number of swaps whose effect was predicted by the linearized tables.
    long swaps_scored = 0;
    std::uint64_t seed = 0;  ///< seed of all random choices
    /// True if the largest utilization and its estimated error keep DesignOptions::max_utilization, if any.
    [[nodiscard]] bool keeps_utilization(const DesignOptions& options) const {
        return design::keeps_utilization(options, largest_utilization, utilization_error);
    }
    /// True if the painting's mass keeps DesignOptions::max_mass, if any.
    [[nodiscard]] bool keeps_mass(const DesignOptions& options) const {
        return options.max_mass <= 0.0 || mass <= options.max_mass;
    }
    /// True if the painting's mean error is less than 1 - kLeastDesignGain times that of the best single
    /// pattern, and less than the largest wanted displacement. False if an error is not known.
    [[nodiscard]] bool is_better() const {
        return error && best_uniform && error->mean < (1.0 - kLeastDesignGain) * best_uniform->mean &&
               error->mean < 1.0;
    }
};

/// Paint the tiles of a project so that its surface takes the target's shape (method: README.md). After a
/// stop, the report has the best painting so far; a stop before the first painting throws base::Stopped.
/// Throws InputError that names an unsuitable target, palette, load case or kept tile; NumericalError if the
/// supports do not hold the surface. `library` may be null; the setting is that of setting_of().
DesignReport design(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
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
    int solutions = 0;     ///< nonlinear solutions so far
    double seconds = 0.0;  ///< since the search began
    double misfit = 0.0;   ///< root of the weighted mean square distance of the reduced model, a share of the
                           ///< largest displacement wanted
};

/// Options of design().
struct DesignOptions {
    std::string load_case;                       ///< the project's load case for goals that name none
    std::vector<pattern::NamedPattern> palette;  ///< patterns to choose from
    std::size_t max_patterns =
        0;  ///< most different patterns of the surface, kept tiles included; 0: any number
    std::vector<tiling::TileIndex> keep;  ///< tiles that keep their patterns
    Symmetry symmetry;                    ///< that the painting keeps
    double max_mass = 0.0;                ///< kg, of all beams; 0: any
    double max_utilization = 0.0;  ///< largest share of the setting's strength, checked with all beams;
                                   ///< 0: any
    bool free_factor = false;      ///< the factor on each load case's loads is searched, too
    bool free_prescribed = false;  ///< the values of its prescribed displacements are searched, too
    bool free_width = false;       ///< the width of all bars is searched, too; they have to be rectangular
    bool free_thickness = false;   ///< the thickness of all bars is searched, too
    /// Smallest gap between bars, m. Patterns whose own bars come nearer to each other are left out, and the
    /// result is the best checked painting that keeps it. None: any gap.
    std::optional<double> clearance{};
    double seconds = 0.0;  ///< wall time, checks included; 0: any
    /// Most nonlinear solutions of the search; checks and the fits of single patterns take further ones. 0:
    /// 40, and of surfaces of fewer than 44 tiles, whose solutions are cheaper, as many more as there are
    /// fewer tiles, up to 320.
    int most_solutions = 0;
    /// The search begins with this number of them: two thirds of very different stiffness, and then those
    /// that are predicted from these to be the best.
    std::size_t uniform_paintings = 12;
    std::size_t shortlist = 64;  ///< number of patterns that one step of the search chooses from
    std::uint64_t seed = 1;      ///< of all random choices
    int threads = 0;          ///< 0: one for each processor. The number does not change a bit of the result.
    base::Control control{};  ///< how the caller follows and stops the work
    std::function<void(const DesignProgress&)> on_better{};  ///< called on the calling thread; may be empty
    /// Throws InputError if a value is invalid, or does not fit the project.
    void validate(const simulation::Project& project) const;
};

/// Distances to the target over its goals' nodes, as shares of the largest displacement that it asks for.
/// They are those of the full model: the nonlinear equilibrium on the stable path from flat.
struct TargetError {
    double mean = 0.0;       ///< a share of the largest displacement wanted
    double largest = 0.0;    ///< the same of the worst node
    bool is_stable = true;   ///< of all load cases
    bool is_on_path = true;  ///< the whole path from flat is stable; else it snaps on the way
};

/// The shape of a surface under one load case, with all beams, and the places that the target asks for.
struct CaseShape {
    std::string load_case;                ///< its name
    mechanics::NodeValues displacements;  ///< a row for each node of the full model, interface nodes first
    /// A node of a goal.
    struct GoalNode {
        int node = 0;                                      ///< an interface node
        Eigen::Vector3d wanted = Eigen::Vector3d::Zero();  ///< its wanted place, m; free components stay
        double distance = 0.0;                             ///< from there, m
    };
    std::vector<GoalNode> goals;  ///< the nodes of all goals of this load case
};

/// The reason for which the search ended.
enum class DesignEnd {
    NoSwapImproves,  ///< no single swap is predicted to improve the painting, or no predicted improvement
                     ///< came true
    SolutionsSpent,  ///< the solutions were used up
    TimeSpent,       ///< the time was used up
    Stopped,         ///< by the caller
    Unreachable      ///< by DesignReport::bound, no painting comes near the target: none was searched
};
/// The word for it in reports.
std::string_view design_end_name(DesignEnd end);

/// A relative gain below this counts as rounding or chance.
inline constexpr double kLeastDesignGain = 0.01;

/// What design() found.
struct DesignReport {
    simulation::Project project;       ///< painted; with free unknowns, its load cases have their values
    std::optional<TargetError> error;  ///< none if the search was stopped before the check
    std::optional<TargetError> best_uniform;  ///< error of the best single pattern among those tried
    std::string best_uniform_pattern;         ///< its id
    std::size_t uniform_tried = 0;            ///< single patterns that were solved
    int uniform_solutions = 0;          ///< solutions that the single patterns took, with their own unknowns
    std::vector<std::string> patterns;  ///< patterns of the painting
    std::vector<double> factors;        ///< factor on the loads of each load case, in the order of load_cases
    std::vector<std::string> load_cases;        ///< their names
    std::optional<double> largest_utilization;  ///< with all beams; none without a strength
    std::optional<double> width{};              ///< width of the bars, m; none if it is not free
    std::optional<double> thickness{};          ///< thickness of the bars, m; none if it is not free
    /// The bound: no painting of the palette has a smaller misfit (root of the weighted mean square distance,
    /// a share of the largest displacement wanted). It is proven in linear theory, for targets that are small
    /// enough for it (README.md). None for other targets.
    std::optional<double> bound{};
    std::size_t close_bars = 0;               ///< pairs of bars that come nearer than the clearance
    std::vector<std::string> warnings{};      ///< such as goals that nodes cannot reach; one line each
    std::vector<CaseShape> shapes{};          ///< of the painting; empty if it was not checked with all beams
    std::vector<CaseShape> uniform_shapes{};  ///< the same of the best single pattern
    Gamut gamut{};                            ///< curvatures that are wanted and reached
    /// The largest displacement wanted, divided by the largest displacement of the softest uniform painting,
    /// and then of the stiffest one. Values far above one mean that the load is too small for the target.
    double wanted_of_softest = 0.0;
    double wanted_of_stiffest = 0.0;  ///< the same of the stiffest one
    bool nothing_moves = false;       ///< the load cases displace no uniform painting
    /// The displacement of the softest uniform painting under ten times the loads, as a share of the largest
    /// displacement wanted. Only if wanted_of_softest is above two, and there are loads.
    std::optional<double> reach_of_ten_loads{};
    double model_error =
        0.0;  ///< mean distance of the reduced model from the full one, a share like the errors
    std::vector<double> starts;  ///< the misfit that each start of the search reached (DesignProgress)
    std::vector<DesignProgress> history;        ///< each better painting
    DesignEnd end = DesignEnd::NoSwapImproves;  ///< how the search ended
    bool slides = false;                        ///< nodes may slide along a target's surface
    double seconds = 0.0;                       ///< wall time, checks included
    int solutions = 0;                          ///< nonlinear solutions of the search
    int full_solutions = 0;                     ///< nonlinear solutions with all beams, of the checks
    long swaps_scored = 0;                      ///< swaps of a pattern that were scored by superposed answers
    std::uint64_t seed = 0;                     ///< of all random choices
    /// True if the painting's mean error is below that of the best single pattern by a share of at least
    /// kLeastDesignGain, and below the largest displacement wanted. False if this is not known.
    [[nodiscard]] bool is_better() const {
        return error && best_uniform && error->mean < (1.0 - kLeastDesignGain) * best_uniform->mean &&
               error->mean < 1.0;
    }
};

/// Paint the tiles of a project so that its surface takes the target's shape (the method: README.md). After a
/// stop, the report has the best painting so far; a stop before the first painting throws base::Stopped.
/// Throws InputError that names an unsuitable target, palette, load case or kept tile.
DesignReport design(const simulation::Project& project, const library::Library* library, const Target& target,
                    const DesignOptions& options);

}  // namespace fretwork::design

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The distances between the interface nodes of a reduced model and of the full model: a row of the paper's
/// Table 3.
///
/// Means are taken over the interface nodes; sd is the population standard deviation of the errors. The
/// paper's sd columns are inconsistent with the paper's errors and cannot be compared with these values. A
/// rotation error is the angle between the two orientations of a node.
struct Comparison {
    /// Width of the bounding box of the interface nodes at rest, m.
    double width = 0.0;
    double height = 0.0;  ///< m
    /// Largest displacement of an interface node of the full model, m.
    double max_displacement = 0.0;
    double max_translation_error = 0.0;   ///< m
    double mean_translation_error = 0.0;  ///< m
    double sd_translation_error = 0.0;    ///< m
    /// Largest rotation of an interface node of the full model, rad.
    double max_rotation = 0.0;
    double max_rotation_error = 0.0;   ///< rad
    double mean_rotation_error = 0.0;  ///< rad
    double sd_rotation_error = 0.0;    ///< rad
    double relative_l2_error = 0.0;    ///< |full - reduced| / |full| over all translations
    double full_seconds = 0.0;         ///< wall time of the full model's solution, s
    double reduced_seconds = 0.0;      ///< wall time of the reduced model's solution, s
    /// True if the full model's equilibrium is unstable: no specimen would stay in it.
    bool full_is_unstable = false;
    /// Joints of the setting of both results; none if no file states them.
    std::optional<reduction::Joints> joints{};
};

/// The largest displacement of an interface node, m. Every model of a surface has these nodes.
double largest_displacement(const SurfaceResult& result, const mechanics::Solution& solution);
/// The largest rotation of an interface node, rad: the length of its rotation vector.
double largest_rotation(const SurfaceResult& result, const mechanics::Solution& solution);

/// Compare two results of one surface. Nodes are matched by id. Throws InputError if a result did not
/// converge; if an interface node of one result is missing in the other or lies at another place; if the
/// subjects differ in tessellation, painting, setting, load case or load stages; if both results have the
/// same model and the same solver; if only the second result has the full model; if there are no interface
/// nodes; or if displacements are too large to be compared. Subjects are compared if both results have one.
Comparison compare(const SurfaceResult& full, const SurfaceResult& reduced);

/// The comparison in a few lines for people.
std::string comparison_text(const Comparison& comparison);
/// The header of a table of comparisons.
std::string comparison_header();
/// The row of a comparison in that table; `example` is the name of the row.
std::string comparison_row(const std::string& example, const Comparison& comparison);

}  // namespace fretwork::simulation

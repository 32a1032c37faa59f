// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>

#include <optional>
#include <string>

namespace fretwork::simulation {

/// The distances of a reduced model's interface nodes from the full model's: a row of the paper's Table 3.
///
/// Means are taken over the interface nodes; sd is the population standard deviation of the errors. The sd
/// columns of the paper are inconsistent with the errors that it prints, so they cannot be compared with
/// these. A rotation error is the angle of the rotation between the two orientations of a node.
struct Comparison {
    double width = 0.0;                         ///< m, of the interface nodes' bounding box at rest
    double height = 0.0;                        ///< m
    double max_displacement = 0.0;              ///< m, of the full model's interface nodes
    double max_translation_error = 0.0;         ///< m
    double mean_translation_error = 0.0;        ///< m
    double sd_translation_error = 0.0;          ///< m
    double max_rotation = 0.0;                  ///< rad, of the full model
    double max_rotation_error = 0.0;            ///< rad
    double mean_rotation_error = 0.0;           ///< rad
    double sd_rotation_error = 0.0;             ///< rad
    double relative_l2_error = 0.0;             ///< |full - reduced| / |full| over all translations
    double full_seconds = 0.0;                  ///< wall time of the full model's answer
    double reduced_seconds = 0.0;               ///< wall time of the reduced model's
    bool full_is_unstable = false;              ///< the reference is a state in which no specimen would stay
    std::optional<reduction::Joints> joints{};  ///< of both results' setting; none where no file names them
};

/// The largest displacement (m) and rotation (rad, length of the rotation vector) of the interface nodes.
/// Every model of a surface has these nodes, so largest values are taken over them alone.
double largest_displacement(const SurfaceResult& result, const mechanics::Solution& solution);
/// The largest rotation of an interface node, rad.
double largest_rotation(const SurfaceResult& result, const mechanics::Solution& solution);

/// Compare two results of one surface; nodes are matched by id. Throws InputError if a result did not
/// converge; if an interface node of one is missing in the other or lies elsewhere; if the subjects differ in
/// tessellation, painting, setting or load case; or if both have the same model, or only the second has the
/// full model. Subjects are compared only if both results have one.
Comparison compare(const SurfaceResult& full, const SurfaceResult& reduced);

/// The comparison in a few lines for people.
std::string comparison_text(const Comparison& comparison);
/// The header and a row of a table of comparisons.
std::string comparison_header();
/// The row of a comparison under that name.
std::string comparison_row(const std::string& example, const Comparison& comparison);

}  // namespace fretwork::simulation

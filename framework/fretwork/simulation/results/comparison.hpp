// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>

#include <string>

namespace fretwork::simulation {

/// How far a reduced model's interface nodes are from the full model's: a row of the paper's Table 3.
///
/// Means run over the interface nodes; sd is the population's standard deviation of the errors (the paper's
/// two sd columns cannot be that of the errors which it prints, so they are not to be compared). A rotation
/// error is the angle between the two rotated frames.
struct Comparison {
    double width = 0.0;                   ///< m, of the interface nodes' bounding box at rest
    double height = 0.0;                  ///< m
    double max_displacement = 0.0;        ///< m, of the full model's interface nodes
    double max_translation_error = 0.0;   ///< m
    double mean_translation_error = 0.0;  ///< m
    double sd_translation_error = 0.0;    ///< m
    double max_rotation = 0.0;            ///< rad, of the full model
    double max_rotation_error = 0.0;      ///< rad
    double mean_rotation_error = 0.0;     ///< rad
    double sd_rotation_error = 0.0;       ///< rad
    double relative_l2_error = 0.0;       ///< of all translations: |full - reduced| / |full|
    double full_seconds = 0.0;
    double reduced_seconds = 0.0;
    bool full_is_unstable =
        false;  ///< a specimen would go elsewhere: the errors are from a state that none has
};

/// The largest displacement (m) and rotation (rad, of the rotation vector) of the interface nodes, which
/// every model of a surface has: what all of the program calls the largest, whatever nodes a model has
/// inside.
double largest_displacement(const SurfaceResult& result, const mechanics::Solution& solution);
double largest_rotation(const SurfaceResult& result, const mechanics::Solution& solution);

/// Compare two results of one surface; nodes are matched by id. Throws InputError if the results say that
/// they are of different tessellations, paintings, settings or load cases, of one model, or that the second
/// is the full one; if an interface node of one is missing in the other or lies elsewhere; or if a result did
/// not converge. Results without a subject (files of the first format) are not checked for that.
Comparison compare(const SurfaceResult& full, const SurfaceResult& reduced);

/// The comparison in a few lines for people.
std::string comparison_text(const Comparison& comparison);
/// The header of the table, and a row of it.
std::string comparison_header();
std::string comparison_row(const std::string& example, const Comparison& comparison);

}  // namespace fretwork::simulation

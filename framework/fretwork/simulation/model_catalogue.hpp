// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/surface.hpp>

#include <span>
#include <string_view>

namespace fretwork::simulation {

/// A way to turn a surface into a structure. Its first nodes are the interface nodes, with their own ids.
struct ModelRow {
    std::string_view name;
    std::string_view description;
    bool is_nonlinear;  ///< whether it is meant for large displacements
    mechanics::Assembly (*build)(const Surface&, const Conditions&);
};

/// All models: a new one is a file and a row.
std::span<const ModelRow> model_catalogue();
/// Throws InputError that lists what there is.
const ModelRow& find_model(std::string_view name);

/// The full model as a frame: every beam of every tile, one element each. Any other solver can check it.
mechanics::Frame full_model_frame(const Surface& surface, const Conditions& conditions);
mechanics::Assembly build_full_model(const Surface& surface, const Conditions& conditions);

/// Every tile as the paper's six-parameter reduced model with the parameters of its pattern. Paper,
/// Section 5.1. Throws InputError that names a pattern without a calibration.
mechanics::Assembly build_paper6_model(const Surface& surface, const Conditions& conditions);
/// The same as a frame, for drawings.
mechanics::Frame paper6_model_frame(const Surface& surface, const Conditions& conditions);

/// Every tile as the linear stiffness of its own beams, condensed onto its interface nodes.
mechanics::Assembly build_condensed_model(const Surface& surface, const Conditions& conditions);

}  // namespace fretwork::simulation

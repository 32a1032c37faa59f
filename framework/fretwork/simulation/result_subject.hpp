// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/result_file.hpp>
#include <fretwork/simulation/load_case.hpp>
#include <fretwork/simulation/simulation_options.hpp>
#include <fretwork/simulation/surface.hpp>

#include <string>

namespace fretwork::simulation {

/// What a result of this surface under this load case is a result of.
///
/// The tessellation's hash is that of its polygons and nodes, wherever a tile's first vertex is; the
/// painting's that of each tile's pattern and first vertex.
mechanics::ResultSubject result_subject(const Surface& surface, const LoadCase& load_case,
                                        const SimulationOptions& options);

/// What two subjects differ in besides their models, in words ("the painting"); empty: nothing.
/// Descriptions of load cases do not count.
std::string subject_difference(const mechanics::ResultSubject& left, const mechanics::ResultSubject& right);

/// The same for a result and a surface, whose load case may be any.
std::string subject_difference(const mechanics::ResultSubject& result, const Surface& surface);

}  // namespace fretwork::simulation

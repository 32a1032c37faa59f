// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/bar_plan.hpp>
#include <fretwork/fabrication/solid.hpp>

#include <string>

namespace fretwork::exports {

/// Binary STL in millimetres, as slicers take it; the header says so.
std::string solid_stl(const fabrication::Solid& solid);
/// Wavefront OBJ in millimetres; its first line says so.
std::string solid_obj(const fabrication::Solid& solid);
/// PLY (ASCII) in millimetres; its header says so.
std::string solid_ply(const fabrication::Solid& solid);

/// 3MF (core specification 1.3) in millimetres: one object.
std::string solid_3mf(const fabrication::Solid& solid);
/// 3MF with the bars as a beam lattice (extension 1.1) of round bars with the area of the section.
std::string lattice_3mf(const fabrication::BarPlan& plan);

}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/fabrication/shape.hpp>

#include <string>

namespace fretwork::step {

/// A STEP file (AP214) of a shape that is extruded from z = 0 to its height: a solid for each piece, with
/// true circular arcs, in millimetres. `name` is the product's name. Throws NumericalError if OpenCASCADE
/// cannot make valid solids or transfer them, IoError if a temporary file cannot be written, InputError if
/// this file cannot be read again, and Stopped if `control` asks to stop.
std::string step_text(const fabrication::Shape& shape, const std::string& name,
                      const base::Control& control = {});

}  // namespace fretwork::step

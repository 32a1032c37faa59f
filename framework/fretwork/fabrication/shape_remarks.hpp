// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// What of the options could not be had everywhere, one line each: openings that the kerf closes, fillets
/// that do not fit. `left` is what the cutter leaves, made without the kerf; `cut` is where it runs.
std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options);

/// An outline and what is to be said of it.
struct RemarkedShape {
    Shape shape;
    std::vector<std::string> remarks;
};
/// make_shape() with its remarks; a kerf takes the time of a second shape.
RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options);

}  // namespace fretwork::fabrication

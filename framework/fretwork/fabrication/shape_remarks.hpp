// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/fabrication/shape.hpp>

#include <string>
#include <vector>

namespace fretwork::fabrication {

/// The options that could not be met everywhere, one line each: openings that the kerf closes, fillets that
/// do not fit. `left` is the finished part, made without the kerf; `cut` is the cutter's path.
std::vector<std::string> shape_remarks(const Shape& left, const Shape& cut, const ShapeOptions& options);

/// An outline and what is to be said of it.
struct RemarkedShape {
    Shape shape;
    std::vector<std::string> remarks;
};
/// make_shape() with its remarks; a kerf takes the time of a second shape.
RemarkedShape make_remarked_shape(const simulation::Surface& surface, const ShapeOptions& options);

}  // namespace fretwork::fabrication

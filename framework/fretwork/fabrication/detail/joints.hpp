// SPDX-License-Identifier: GPL-3.0-or-later
// How two parts of a surface are joined at an interface node: a knob in a socket, as in a jigsaw.
#pragma once

#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/fabrication/sheets.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// A joint at an interface node on a seam.
struct Joint {
    std::size_t number = 0;
    geometry::Point2 place;
    geometry::Point2 normal;  ///< of length 1, from the part with the knob to that with the socket
    std::size_t knob_part = 0;
    std::size_t socket_part = 0;
};

/// Lengths of a joint, m, from the width of the bars.
struct JointSize {
    explicit JointSize(double width)
        : plate(3.4 * width), knob(0.9 * width), neck(0.5 * width), reach(1.5 * width) {}
    double plate;  ///< radius of both plates together
    double knob;   ///< radius
    double neck;   ///< half of its width
    double reach;  ///< from the seam to the middle of the knob
};

/// The circles by which a joint changes a part: material is removed, then added, then removed again.
struct JointCut {
    std::vector<geometry::Polygon> beyond;
    std::vector<geometry::Polygon> added;
    std::vector<geometry::Polygon> sockets;
    std::vector<Disc> discs;
};

struct JointMaking {
    JointSize size;
    double fit = 0.0;     ///< m, Bed::fit
    double growth = 0.0;  ///< m, half of the kerf
};

/// Add one side of a joint.
enum class JointSide { Knob, Socket };
void add_side(JointCut& cut, const Joint& joint, JointSide side, const JointMaking& making);

/// Where a side's name is engraved.
geometry::Point2 name_place(const Joint& joint, JointSide side, const JointSize& size);

}  // namespace fretwork::fabrication::detail

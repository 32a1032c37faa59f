// SPDX-License-Identifier: GPL-3.0-or-later
// How two parts of a surface are joined at an interface node: a knob in a socket, as in a jigsaw.
#pragma once

#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/fabrication/sheets.hpp>

#include <vector>

namespace fretwork::fabrication::detail {

/// A place on the seam between two parts.
struct SeamPlace {
    geometry::Point2 place;
    geometry::Point2 normal;  ///< of length 1, from the part with knobs to that with sockets
    std::size_t knob_part = 0;
    std::size_t socket_part = 0;
};

/// A connector at an interface node on a seam.
struct Connector : SeamPlace {
    std::size_t number = 0;
};

/// Lengths of a connector, m, as multiples of the width of the bars.
struct ConnectorSize {
    explicit ConnectorSize(double width)
        : plate(3.4 * width), knob(0.9 * width), neck(0.5 * width), reach(1.5 * width) {}
    double plate;  ///< radius of both plates together
    double knob;   ///< radius
    double neck;   ///< half of its width
    double reach;  ///< from the seam to the middle of the knob
};

/// The shapes by which connectors change a part: `beyond` is removed, `added` is added, and `sockets` are
/// removed, in this order. `discs` are the circles in these shapes.
struct ConnectorCut {
    std::vector<geometry::Polygon> beyond;
    std::vector<geometry::Polygon> added;
    std::vector<geometry::Polygon> sockets;
    std::vector<Disc> discs;
};

struct ConnectorMaking {
    ConnectorSize size;
    double fit = 0.0;     ///< m, Bed::fit
    double growth = 0.0;  ///< m, half of the kerf
};

/// A side of a connector.
enum class ConnectorSide { Knob, Socket };
/// Add one side of a connector.
void add_side(ConnectorCut& cut, const Connector& connector, ConnectorSide side,
              const ConnectorMaking& making);

/// Remove what a part's frame has beyond the seam, within a disc around an end of the seam at the rim.
void cut_frame(ConnectorCut& cut, const SeamPlace& end, ConnectorSide side, double radius,
               const ConnectorMaking& making);

/// Polygons with openings, after the cuts.
std::vector<geometry::Polygon> with_connectors(const std::vector<geometry::Polygon>& touched,
                                               const ConnectorCut& cut);

/// The place at which a connector's number is engraved on a side.
geometry::Point2 name_place(const Connector& connector, ConnectorSide side, const ConnectorSize& size);

}  // namespace fretwork::fabrication::detail

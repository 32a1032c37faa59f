// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/clipping.hpp>
#include <fretwork/fabrication/detail/connectors.hpp>
#include <fretwork/geometry/plane.hpp>

namespace fretwork::fabrication::detail {
namespace {

using geometry::Point2;

/// The part of a disc that lies further than `offset` along a normal from its center.
geometry::Polygon disc_beyond(const Disc& disc, const Point2& normal, double offset) {
    const double half = std::acos(std::clamp(offset / disc.radius, -1.0, 1.0));
    const double middle = std::atan2(normal.y, normal.x);
    const int chords = static_cast<int>(std::ceil(2.0 * half / kChordAngle));
    geometry::Polygon polygon;
    for (int i = 0; i <= chords; ++i)
        polygon.push_back(disc.center +
                          disc.radius * geometry::direction(middle - half + 2.0 * half * i / chords));
    return polygon;
}

/// The neck from behind the seam to the middle of the knob.
geometry::Polygon neck(const Connector& connector, const ConnectorMaking& making, double growth) {
    const Point2 aside = (making.size.neck + growth) * left_of(connector.normal);
    const Point2 from = connector.place - making.size.neck * connector.normal;
    const Point2 to = connector.place + making.size.reach * connector.normal;
    return {from - aside, to - aside, to + aside, from + aside};
}

}  // namespace

void add_side(ConnectorCut& cut, const Connector& connector, ConnectorSide side,
              const ConnectorMaking& making) {
    const ConnectorSize& size = making.size;
    const Disc plate{connector.place, size.plate + making.growth};
    const Point2 knob_center = connector.place + size.reach * connector.normal;
    const Point2 back = -1.0 * connector.normal;
    cut.discs.push_back(plate);
    if (side == ConnectorSide::Knob) {
        const double seam = making.growth;
        const Disc knob{knob_center, size.knob + making.growth};
        cut.beyond.push_back(disc_beyond(plate, connector.normal, seam));
        cut.added.push_back(disc_beyond(plate, back, -seam));
        cut.added.push_back(disc_patch(knob).polygon);
        cut.added.push_back(neck(connector, making, making.growth));
        cut.discs.push_back(knob);
    } else {
        const double seam = making.fit - making.growth;
        const Disc socket{knob_center, size.knob + seam};
        cut.beyond.push_back(disc_beyond(plate, back, -seam));
        cut.added.push_back(disc_beyond(plate, connector.normal, seam));
        cut.sockets.push_back(disc_patch(socket).polygon);
        cut.sockets.push_back(neck(connector, making, seam));
        cut.discs.push_back(socket);
    }
}

void cut_frame(ConnectorCut& cut, const SeamPlace& end, ConnectorSide side, double radius,
               const ConnectorMaking& making) {
    const Disc disc{end.place, radius};
    cut.beyond.push_back(side == ConnectorSide::Knob
                             ? disc_beyond(disc, end.normal, making.growth)
                             : disc_beyond(disc, -1.0 * end.normal, making.growth - making.fit));
}

std::vector<geometry::Polygon> with_connectors(const std::vector<geometry::Polygon>& touched,
                                               const ConnectorCut& cut) {
    if (cut.added.empty()) return touched;
    std::vector<geometry::Polygon> all = without(touched, united(cut.beyond));
    const std::vector<geometry::Polygon> added = united(cut.added);
    all = merged(all, added);
    return cut.sockets.empty() ? all : without(all, united(cut.sockets));
}

Point2 name_place(const Connector& connector, ConnectorSide side, const ConnectorSize& size) {
    const double along = side == ConnectorSide::Knob ? -0.35 : 0.35;
    return connector.place + along * size.plate * connector.normal +
           0.62 * size.plate * left_of(connector.normal);
}

}  // namespace fretwork::fabrication::detail

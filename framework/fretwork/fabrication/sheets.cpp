// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/fabrication/detail/assembling.hpp>
#include <fretwork/fabrication/detail/clipping.hpp>
#include <fretwork/fabrication/detail/connectors.hpp>
#include <fretwork/fabrication/detail/fillets.hpp>
#include <fretwork/fabrication/detail/length_text.hpp>
#include <fretwork/fabrication/detail/motion.hpp>
#include <fretwork/fabrication/detail/parts.hpp>
#include <fretwork/fabrication/detail/patches.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/geometry/plane.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <ranges>
#include <utility>

namespace fretwork::fabrication {
namespace {

using geometry::Box;
using geometry::Point2;

using namespace detail;
using geometry::Polygon;

/// A part in its place in the surface.
struct Part {
    std::vector<Piece> pieces;
    std::vector<Label> engraved;
    std::vector<Label> labels;
};

std::string part_name(std::size_t part) {
    return "P" + std::to_string(part + 1);
}

/// All parts at their places in the surface.
Shape shape_of(const std::vector<Part>& parts) {
    Shape shape;
    for (const Part& part : parts)
        shape.pieces.insert(shape.pieces.end(), part.pieces.begin(), part.pieces.end());
    return shape;
}

class SheetCutter {
  public:
    SheetCutter(const simulation::Surface& surface, const ShapeOptions& options, const Bed& bed)
        : surface_(surface),
          options_(options),
          bed_(bed),
          plan_(checked_plan(surface, options)),
          size_(plan_.width),
          part_of_tile_(parts_of_tiles(
              surface.tessellation, bed,
              {reach(), size_.plate + bed.fit, options.control, holes(), 0.5 * options.bolt_diameter})) {}

    SheetSet run() {
        find_connectors();
        const std::vector<Part> parts = make_parts();
        return {nest(parts), assembly(parts), parts.size(), connectors_.size(), remarks(parts)};
    }

  private:
    [[nodiscard]] std::vector<Part> make_parts() const {
        const std::size_t count = 1 + *std::ranges::max_element(part_of_tile_);
        std::vector<Part> parts;
        for (std::size_t p = 0; p < count; ++p) {
            options_.control.check();
            parts.push_back(make_part(p));
        }
        return parts;
    }

    /// Remarks on the kerf in the parts, and on the fillets in the whole outline: connectors have none.
    [[nodiscard]] std::vector<std::string> remarks(const std::vector<Part>& parts) const {
        const ShapeOptions finished = options_.without_kerf();
        std::vector<std::string> all;
        if (options_.kerf > 0.0) {
            SheetCutter same = *this;  // the same seams
            same.options_ = finished;
            ShapeOptions kerf = options_;
            kerf.fillet = 0.0;
            all = shape_remarks(shape_of(same.make_parts()), shape_of(parts), kerf);
        }
        if (options_.fillet > 0.0) {
            const Shape whole = make_shape(plan_, finished);
            std::ranges::move(shape_remarks(whole, whole, finished), std::back_inserter(all));
        }
        return all;
    }

    static BarPlan checked_plan(const simulation::Surface& surface, const ShapeOptions& options) {
        BarPlan plan = bar_plan(surface, options.frame_width);
        if (options.bolt_diameter > 0.0) require_bars_at_bolts(plan, options.bolts);
        return plan;
    }

    /// How far material lies beyond the tiles of a part: plates of connectors, half a frame, eyes.
    [[nodiscard]] double reach() const {
        double farthest = std::max(size_.plate, 0.5 * (options_.frame_width + options_.kerf));
        if (!options_.bolts.empty() && options_.bolt_diameter > 0.0)
            farthest = std::max(farthest, options_.eye_radius());
        return farthest;
    }

    /// The places of holes for bolts.
    [[nodiscard]] std::vector<Point2> holes() const {
        std::vector<Point2> places;
        if (options_.bolt_diameter == 0.0) return places;
        for (const TessellationNodeIndex node : options_.bolts) places.push_back(plan_.nodes[node]);
        return places;
    }

    /// Add connectors to sides between two parts.
    void find_connectors() {
        for (const tiling::SharedSide& side : tiling::shared_sides(surface_.tessellation)) {
            if (part_of_tile_[side.tiles[0]] == part_of_tile_[side.tiles[1]]) continue;
            add_connectors(side);
            if (options_.frame_width > 0.0) add_seam_ends(side);
        }
    }

    /// A place on a side, with the two parts that meet there.
    [[nodiscard]] SeamPlace on_seam(const tiling::SharedSide& side, const Point2& place) const {
        const auto& vertices = surface_.tessellation.vertices;
        const Point2 outward = left_of(unit(vertices[side.to] - vertices[side.from]));  // from the first tile
        const std::size_t first = part_of_tile_[side.tiles[0]];
        const std::size_t second = part_of_tile_[side.tiles[1]];
        return {place, first < second ? outward : -1.0 * outward, std::min(first, second),
                std::max(first, second)};
    }

    /// Add the ends of a side that lie on the rim. Ends with more than two tiles stay as they are: a cut
    /// could remove the frame of a third tile.
    void add_seam_ends(const tiling::SharedSide& side) {
        const tiling::Tessellation& tessellation = surface_.tessellation;
        for (const tiling::VertexIndex vertex : {side.from, side.to}) {
            const auto is_there = [&](const tiling::Tile& tile) {
                return std::ranges::find(tile.vertices, vertex) != tile.vertices.end();
            };
            if (std::ranges::count_if(tessellation.tiles, is_there) > 2) continue;
            seam_ends_.push_back(on_seam(side, tessellation.vertices[vertex]));
        }
    }

    /// The first tile's polygon gives the order of the connectors; `side` runs in the opposite direction.
    void add_connectors(const tiling::SharedSide& side) {
        const tiling::Tessellation& tessellation = surface_.tessellation;
        const Point2& from = tessellation.vertices[side.to];
        const Point2& to = tessellation.vertices[side.from];
        for (const auto node : side.nodes | std::views::reverse) {
            const Point2& place = tessellation.interface_nodes[node];
            require_room(place, {from, to}, node);
            require_no_hole(place, node);
            connectors_.push_back({on_seam(side, place), connectors_.size() + 1});
        }
    }

    /// Check that a connector's plate ends before its side's ends, and before the next connector's plate.
    void require_room(const Point2& place, const std::array<Point2, 2>& ends, int node) const {
        double room = std::min(distance(place, ends[0]), distance(place, ends[1]));
        for (const Connector& connector : connectors_)
            room = std::min(room, 0.5 * distance(place, connector.place));
        if (room > size_.plate + bed_.fit) return;
        throw base::InputError("the connector at node " + std::to_string(node) + ", " + place_text(place) +
                               ", has no room: its plate takes " + base::format_number(1e3 * size_.plate) +
                               " mm around it; narrower beams or larger tiles are needed, or a larger bed");
    }

    /// Check that a connector's plate fills no hole for a bolt.
    void require_no_hole(const Point2& place, int node) const {
        for (const Point2& hole : holes()) {
            if (distance(place, hole) > size_.plate + bed_.fit + 0.5 * options_.bolt_diameter) continue;
            throw base::InputError("the connector at node " + std::to_string(node) + ", " +
                                   place_text(place) + ", would fill the hole for a bolt at " +
                                   place_text(hole) + "; another support or a larger bed is needed");
        }
    }

    [[nodiscard]] BarPlan part_plan(std::size_t part) const {
        BarPlan plan = plan_;
        std::erase_if(plan.bars, [&](const Bar& bar) { return part_of_tile_[bar.tile] != part; });
        return plan;
    }

    [[nodiscard]] Part make_part(std::size_t number) const {
        const BarPlan plan = part_plan(number);
        const auto nodes = nodes_with_bars(plan);
        ShapeOptions options = options_;
        options.fillet = 0.0;  // fillets come after connectors
        std::erase_if(options.bolts, [&](TessellationNodeIndex node) { return !nodes.contains(node); });
        const Shape shape = make_shape(plan, options);
        Part part{joined_pieces(shape, number, plan), {}, {}};
        for (const Connector& connector : connectors_)
            if (const auto side = side_of(connector, number))
                part.engraved.push_back({name_place(connector, *side, size_),
                                         std::to_string(connector.number), 0.9 * plan_.width});
        const auto tiles = tile_labels(surface_.tessellation);
        for (std::size_t t = 0; t < tiles.size(); ++t)
            if (part_of_tile_[t] == number) part.labels.push_back(tiles[t]);
        const Box box = box_of(part.pieces.front().outer);
        part.labels.push_back({{box.xmin + 0.02, box.ymin + 0.006}, part_name(number), 0.008});
        return part;
    }

    /// The side of a part at a connector or an end of a seam; none: other parts meet there.
    static std::optional<ConnectorSide> side_of(const SeamPlace& seam, std::size_t part) {
        if (seam.knob_part == part) return ConnectorSide::Knob;
        if (seam.socket_part == part) return ConnectorSide::Socket;
        return std::nullopt;
    }

    /// Add the cuts at a part's connectors and at the ends of its frame. Returns the boxes around them.
    [[nodiscard]] std::vector<Box> add_cuts(ConnectorCut& cut, std::size_t number) const {
        // Corners of frames lie farther from the end of the seam than half their width.
        const double frame = kFrameReach * 0.5 * (options_.frame_width + options_.kerf);
        const ConnectorMaking making{size_, bed_.fit, 0.5 * options_.kerf};
        std::vector<Box> boxes;
        const auto add_box = [&](const Point2& place, double margin) {
            boxes.push_back(geometry::grown({place.x, place.y, place.x, place.y}, margin));
        };
        for (const Connector& connector : connectors_) {
            const auto side = side_of(connector, number);
            if (!side) continue;
            add_side(cut, connector, *side, making);
            add_box(connector.place, 1.5 * size_.plate);
        }
        for (const SeamPlace& end : seam_ends_) {
            const auto side = side_of(end, number);
            if (!side) continue;
            cut_frame(cut, end, *side, frame, making);
            add_box(end.place, frame);
        }
        return boxes;
    }

    /// Cut the connectors of a part into its contours. Contours away from connectors keep their arcs.
    [[nodiscard]] std::vector<Piece> joined_pieces(const Shape& shape, std::size_t number,
                                                   const BarPlan& plan) const {
        ConnectorCut cut;
        const std::vector<Box> plates = add_cuts(cut, number);
        std::vector<Contour> contours;
        std::vector<Polygon> touched;
        const auto sort_in = [&](const Contour& contour) {
            const Box box = fabrication::box_of(contour);
            const bool near = signed_area(contour) > 0.0 ||
                              std::ranges::any_of(plates, [&](const Box& plate) { return plate.meets(box); });
            if (near && !plates.empty())
                touched.push_back(flattened(contour, kChordShare * plan.width));
            else
                contours.push_back(with_fillets(contour, options_.contour_fillet()));
        };
        for (const Piece& piece : shape.pieces) {
            sort_in(piece.outer);
            for (const Contour& opening : piece.openings) sort_in(opening);
        }
        for (const Patch& patch : bar_patches(plan, options_.kerf))
            if (patch.disc) cut.discs.push_back(*patch.disc);
        add_bolts(cut);
        for (const Polygon& polygon : with_connectors(touched, cut))
            contours.push_back(
                fillets_away_from_connectors(with_arcs(polygon, near_discs(polygon, cut.discs))));
        return assembled(contours);
    }

    /// Add eyes and holes to the circles for with_arcs().
    void add_bolts(ConnectorCut& cut) const {
        if (options_.bolt_diameter == 0.0) return;
        for (const TessellationNodeIndex node : options_.bolts) {
            const Point2& place = plan_.nodes[node];
            cut.discs.push_back({place, options_.eye_radius()});
            cut.discs.push_back({place, options_.hole_radius()});
        }
    }

    /// Contours with a connector get no fillets, because the corners of knobs and sockets must fit.
    [[nodiscard]] Contour fillets_away_from_connectors(const Contour& contour) const {
        for (const ContourPoint& point : contour) {
            for (const Connector& connector : connectors_)
                if (distance(point.place, connector.place) < size_.plate + bed_.fit) return contour;
        }
        return with_fillets(contour, options_.contour_fillet());
    }

    [[nodiscard]] std::vector<CutSheet> nest(const std::vector<Part>& parts) const {
        std::vector<Box> boxes;
        for (const Part& part : parts) {
            Box box = box_of(part.pieces.front().outer);
            for (const Piece& piece : part.pieces) box = geometry::united(box, box_of(piece.outer));
            boxes.push_back(box);
        }
        const std::vector<Nest> nests = nested(boxes, bed_);
        std::vector<CutSheet> sheets;
        for (std::size_t p = 0; p < parts.size(); ++p) {
            while (sheets.size() <= nests[p].sheet)
                sheets.push_back({.title = "Sheet " + std::to_string(sheets.size() + 1),
                                  .pieces = {},
                                  .engraved = {},
                                  .labels = {}});
            Motion motion{nests[p].is_turned, {}};
            const Point2 corner = motion.is_turned ? Point2{-boxes[p].ymax, boxes[p].xmin}
                                                   : Point2{boxes[p].xmin, boxes[p].ymin};
            motion.shift = nests[p].corner - corner;
            append_moved(sheets[nests[p].sheet], {"", parts[p].pieces, parts[p].engraved, parts[p].labels},
                         motion);
        }
        return sheets;
    }

    [[nodiscard]] CutSheet assembly(const std::vector<Part>& parts) const {
        CutSheet drawing{.title = "Assembly", .pieces = {}, .engraved = {}, .labels = {}};
        for (const Part& part : parts) {
            drawing.labels.insert(drawing.labels.end(), part.labels.begin(), part.labels.end());
            drawing.labels.insert(drawing.labels.end(), part.engraved.begin(), part.engraved.end());
            for (const Piece& piece : part.pieces) {
                drawing.guides.push_back(piece.outer);
                drawing.guides.insert(drawing.guides.end(), piece.openings.begin(), piece.openings.end());
            }
        }
        return drawing;
    }

    static constexpr double kFrameReach = 1.5;   // enough for frames that meet at 84 degrees or more
    static constexpr double kChordShare = 5e-4;  // share of a bar's width; chords become as short as in discs
    const simulation::Surface& surface_;
    ShapeOptions options_;
    const Bed& bed_;
    BarPlan plan_;
    ConnectorSize size_;
    base::IndexVector<TileIndex, std::size_t> part_of_tile_;
    std::vector<Connector> connectors_;
    std::vector<SeamPlace> seam_ends_;
};

}  // namespace

void Bed::validate() const {
    const auto require = [](double value, double least, const char* what) {
        if (std::isfinite(value) && value >= least) return;
        throw base::InputError(std::string(what) + " is " + base::format_number(value) +
                               " m and must be at least " + base::format_number(least) + " m");
    };
    require(width, 1e-3, "the width of the bed");
    require(height, 1e-3, "the height of the bed");
    require(margin, 0.0, "the margin of the bed");
    require(spacing, 0.0, "the spacing of parts");
    require(fit, 0.0, "the fit of connectors");
}

SheetSet cut_into_sheets(const simulation::Surface& surface, const ShapeOptions& options, const Bed& bed) {
    options.validate();
    bed.validate();
    return SheetCutter(surface, options, bed).run();
}

CutSheet side_by_side(const SheetSet& set, const Bed& bed) {
    constexpr double kApart = 0.02;   // m
    constexpr double kTitle = 0.008;  // m
    CutSheet drawing{.title = std::to_string(set.parts) + " parts on " + std::to_string(set.sheets.size()) +
                              " sheets, " + std::to_string(set.connectors) + " connectors",
                     .pieces = {},
                     .engraved = {},
                     .labels = {}};
    for (std::size_t s = 0; s < set.sheets.size(); ++s) {
        const Motion motion{false, {static_cast<double>(s) * (bed.width + kApart), 0.0}};
        append_moved(drawing, set.sheets[s], motion);
        const Polygon edge = {{0.0, 0.0}, {bed.width, 0.0}, {bed.width, bed.height}, {0.0, bed.height}};
        drawing.guides.push_back(moved(straight(edge), motion));
        drawing.labels.push_back({motion({0.5 * bed.width, -kTitle}), set.sheets[s].title, kTitle});
    }
    Box box = box_of(set.assembly.guides.front());
    for (const Contour& guide : set.assembly.guides) box = united(box, box_of(guide));
    const Motion motion{false, {-box.xmin, bed.height + 2.0 * kApart - box.ymin}};
    append_moved(drawing, set.assembly, motion);
    drawing.labels.push_back({motion({box.middle().x, box.ymax + kTitle}), set.assembly.title, kTitle});
    return drawing;
}

}  // namespace fretwork::fabrication

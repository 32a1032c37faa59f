// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the closed curves in the model space of a DXF drawing, on layers that are on.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/plane.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/detail/remarks.hpp>
#include <fretwork/outlines/dxf/dxf_curves.hpp>
#include <fretwork/outlines/regions/drawn_lines.hpp>
#include <fretwork/outlines/regions/filled_region.hpp>

#include <algorithm>
#include <numbers>

namespace fretwork::outlines::detail {
namespace {

using geometry::Point2;
using geometry::Polygon;

constexpr std::string_view kInherited = "0";  // the name of the layer that means the one of the INSERT
constexpr int kDeepestBlock = 32;             // depth of blocks in blocks
constexpr int kMostEntities = 200'000;        // blocks of blocks grow fast
constexpr std::size_t kMostPoints = 200'000;  // points whose lines are tested for crossings
// Characters of all entities, each as often as it is drawn, which take seconds.
constexpr std::size_t kMostRead = 1'000'000'000;

struct UnitName {
    long number;
    double metres;
    const char* name;
};
constexpr std::array<UnitName, 16> kUnits = {{{1, 0.0254, "in"},
                                              {2, 0.3048, "ft"},
                                              {3, 1609.344, "mi"},
                                              {4, 1e-3, "mm"},
                                              {5, 1e-2, "cm"},
                                              {6, 1.0, "m"},
                                              {7, 1e3, "km"},
                                              {8, 2.54e-8, "microinch"},
                                              {9, 2.54e-5, "mil"},
                                              {10, 0.9144, "yd"},
                                              {13, 1e-6, "micrometre"},
                                              {14, 0.1, "dm"},
                                              {15, 10.0, "dam"},
                                              {16, 100.0, "hm"},
                                              {21, 1200.0 / 3937, "US survey ft"},
                                              {22, 100.0 / 3937, "US survey in"}}};

/// The place of an entity: in the drawing, or in a block that the drawing inserts.
struct Place {
    Affine to_metres{};
    DxfFile::Layer layer{};  // the layer of entities on layer 0
    int depth = 0;
};

class DxfReader {
  public:
    explicit DxfReader(const std::filesystem::path& path)
        : file_(path.string(), base::read_text_file(path)) {}

    OutlineFile run() {
        const double unit = metres_per_unit();
        how_.tolerance = flattening_tolerance(unit * extent());
        read(file_.entities(), {.to_metres = {unit, 0, 0, unit, 0, 0}, .layer = file_.layer(kInherited)});
        Enclosed enclosed = enclosed_by(lines_, how_.tolerance, remarks_);
        open_ = std::move(enclosed.open);
        Region region = nested_region(enclosed.curves, how_.tolerance);
        if (region.parts.empty()) fail_open();
        tell_open();
        remarks_.add_changes(region, how_.tolerance);
        return {std::move(region.parts), remarks_.list()};
    }

  private:
    /// The unit of $INSUNITS in the header; millimetres if the header states none or "unitless".
    double metres_per_unit() {
        const auto group = file_.units();
        const long number = group ? file_.whole_number(*group) : 0;
        if (number == 0) {
            remarks_.add("it does not say its unit; it is taken as mm");
            return 1e-3;
        }
        const auto unit = std::ranges::find(kUnits, number, &UnitName::number);
        if (unit != kUnits.end()) return unit->metres;
        std::vector<std::string> known;
        for (const UnitName& one : kUnits)
            known.push_back(std::to_string(one.number) + " (" + one.name + ")");
        file_.fail(group->line + 1, "$INSUNITS is " + std::to_string(number) + ", where one of " +
                                        base::join(known, ", ") + " is needed");
    }

    /// The approximate extent of the drawing, in its unit. For a drawing with nothing but blocks, the extent
    /// of the blocks.
    [[nodiscard]] double extent() const {
        double extent = extent_of(file_.entities());
        if (extent > 0) return extent;
        for (const auto& [name, block] : file_.blocks()) extent = std::max(extent, extent_of(block.entities));
        return extent;
    }
    /// The largest range of a coordinate, or the largest radius.
    [[nodiscard]] double extent_of(const std::vector<DxfEntity>& entities) const {
        std::array<std::optional<std::array<double, 2>>, 2> range;
        double extent = 0;
        for (const DxfEntity& entity : entities) {
            if (entity.name == "CIRCLE" || entity.name == "ARC")
                extent = std::max(extent, std::abs(file_.value_or(entity, 40, 0)));
            for (const DxfGroup& group : entity.groups) {
                const int axis = group.code == 10 || group.code == 11   ? 0
                                 : group.code == 20 || group.code == 21 ? 1
                                                                        : -1;
                if (axis < 0) continue;
                const double value = file_.number(group);
                auto& known = range[axis];
                if (!known) known = {value, value};
                known = {std::min((*known)[0], value), std::max((*known)[1], value)};
            }
        }
        for (const auto& known : range)
            if (known) extent = std::max(extent, (*known)[1] - (*known)[0]);
        return extent;
    }

    void read(const std::vector<DxfEntity>& entities, const Place& place) {
        const std::span<const DxfEntity> all(entities);
        for (std::size_t i = 0; i < all.size(); ++i) read_entity(all.subspan(i), place);
    }

    void read_entity(std::span<const DxfEntity> from, const Place& place) {
        const DxfEntity& entity = from.front();
        if (++entities_ > kMostEntities)
            file_.fail(entity.line, "with all blocks, the drawing has more than " +
                                        std::to_string(kMostEntities) + " entities");
        read_ += entity.size;
        if (read_ > kMostRead)
            file_.fail(entity.line, "with all blocks, the entities have more than " +
                                        std::to_string(kMostRead) + " characters");
        if (entity.name == "VERTEX" || entity.name == "SEQEND") return;
        if (file_.whole_or(entity, 67, 0) == 1) return remarks_.leave_out("in paper space");
        if (file_.whole_or(entity, 60, 0) == 1) return remarks_.leave_out("invisible");
        const std::string_view layer = file_.text_or(entity, 8, kInherited);
        const DxfFile::Layer state = layer == kInherited ? place.layer : file_.layer(layer);
        const bool is_insert = entity.name == "INSERT";
        // If the layer of a block is off, its entities follow their own layers; a frozen layer hides all of
        // them.
        if (state == DxfFile::Layer::Frozen || (state == DxfFile::Layer::Off && !is_insert))
            return remarks_.leave_out("on layers that are off");
        if (is_insert) return read_insert(entity, {place.to_metres, state, place.depth + 1});
        add(draw_dxf_entity(file_, from, {{place.to_metres, how_.tolerance}, kMostPoints - points_}), entity);
    }

    void add(DxfDrawn drawn, const DxfEntity& entity) {
        if (!drawn.left_out.empty()) remarks_.leave_out(drawn.left_out);
        if (!drawn.curve) return;
        Polygon& points = drawn.curve->points;
        points_ += points.size();
        if (points_ > kMostPoints)
            file_.fail(entity.line, "up to here the drawing has more than " + std::to_string(kMostPoints) +
                                        " points, which is more than an outline can use");
        for (const Point2& point : points)
            if (!std::isfinite(point.x) || !std::isfinite(point.y))
                file_.fail(entity.line, std::string(entity.name) + " has a point that is not finite");
        if (drawn.curve->ends == DxfCurve::Ends::Closed) {
            geometry::remove_repeated_points(points, kClosingShare * how_.tolerance);
            if (points.size() > 2) lines_.closed.push_back(std::move(points));
        } else {
            lines_.open.push_back(std::move(points));
            line_numbers_.push_back(entity.line);
        }
    }

    void read_insert(const DxfEntity& insert, const Place& place) {
        const DxfFile::Block* block = file_.block(file_.text_or(insert, 2, ""));
        if (!block) return remarks_.leave_out("INSERT of a block that is not there");
        if (place.depth > kDeepestBlock || std::ranges::find(inserting_, block) != inserting_.end())
            file_.fail(insert.line, "INSERT: the block contains itself, or blocks lie more than " +
                                        std::to_string(kDeepestBlock) + " deep");
        const auto orientation = dxf_orientation(file_, insert);
        if (!orientation) return remarks_.leave_out("INSERT that does not lie flat");
        inserting_.push_back(block);
        const Affine at =
            place.to_metres.after(*orientation)
                .after({1, 0, 0, 1, file_.value_or(insert, 10, 0), file_.value_or(insert, 20, 0)});
        const double angle = file_.value_or(insert, 50, 0) * std::numbers::pi / 180;
        const Affine turned =
            at.after({std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0});
        const Affine scaled{file_.value_or(insert, 41, 1), 0, 0, file_.value_or(insert, 42, 1), 0, 0};
        const long columns = std::max(1L, file_.whole_or(insert, 70, 1));
        const long rows = std::max(1L, file_.whole_or(insert, 71, 1));
        if (columns > kMostEntities || rows > kMostEntities || columns * rows > kMostEntities)
            file_.fail(insert.line, "INSERT has more than " + std::to_string(kMostEntities) + " copies");
        const Point2 step{file_.value_or(insert, 44, 0), file_.value_or(insert, 45, 0)};
        for (long copy = 0; copy < columns * rows; ++copy) {
            if (++copies_ > kMostEntities)
                file_.fail(insert.line, "with all blocks, the drawing has more than " +
                                            std::to_string(kMostEntities) + " copies of blocks");
            const auto column = static_cast<double>(copy % columns);
            const auto full_rows = copy / columns;
            const auto row = static_cast<double>(full_rows);
            const Affine moved{1, 0, 0, 1, column * step.x, row * step.y};
            read(block->entities,
                 {turned.after(moved).after(scaled).after({1, 0, 0, 1, -block->base_x, -block->base_y}),
                  place.layer, place.depth});
        }
        inserting_.pop_back();
    }

    void tell_open() {
        if (open_.empty()) return;
        const std::size_t longest = longest_of(lines_.open, open_);
        leave_out_open(lines_.open, open_, "line " + std::to_string(line_numbers_[longest]), remarks_);
    }
    [[noreturn]] void fail_open() const {
        std::string left_out = remarks_.left_out();
        if (!left_out.empty()) left_out = " (" + left_out + ")";
        if (open_.empty()) throw base::GeometryError("there is no closed curve" + left_out);
        const std::size_t line = open_.front();
        const auto text = [](Point2 place) {
            return "(" + in_millimetres(place.x) + ", " + in_millimetres(place.y) + ") mm";
        };
        file_.fail(line_numbers_[line],
                   "there is no closed curve: the one that begins here, from " +
                       text(lines_.open[line].front()) + " to " + text(lines_.open[line].back()) +
                       ", is not closed; loose ends are joined up to " +
                       roughly_in_millimetres(widest_gap(how_.tolerance)) + " mm" + left_out);
    }

    DxfFile file_;
    Flattening how_{.tolerance = kFlatteningTolerance};
    DrawnLines lines_;
    std::vector<int> line_numbers_;  // for each open line, its line in the file
    std::vector<std::size_t> open_;  // indices of the open lines that enclose nothing
    std::vector<const DxfFile::Block*> inserting_;
    Remarks remarks_;
    int entities_ = 0;
    int copies_ = 0;  // of blocks; those of empty blocks are not among the entities
    std::size_t read_ = 0;
    std::size_t points_ = 0;
};

}  // namespace

OutlineFile read_dxf_outlines(const std::filesystem::path& path) {
    return DxfReader(path).run();
}

}  // namespace fretwork::outlines::detail

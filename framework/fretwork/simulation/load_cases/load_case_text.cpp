// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/geometry/internal/message_text.hpp>
#include <fretwork/mechanics/standard_gravity.hpp>
#include <fretwork/simulation/detail/line_bearers.hpp>
#include <fretwork/simulation/internal/load_case_json.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/load_case_text.hpp>
#include <fretwork/tiling/painting/tile_choice.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>

namespace fretwork::simulation {
namespace {

using geometry::Point2;
using tiling::Tessellation;

std::string vector_text(const Eigen::Vector3d& vector) {
    return "(" + geometry::short_number(vector.x()) + ", " + geometry::short_number(vector.y()) + ", " +
           geometry::short_number(vector.z()) + ")";
}

struct SelectionText {
    std::string operator()(const NodesById&) const { return "by number"; }
    std::string operator()(const NodesInBox& in) const {
        return "box " + geometry::place_text({in.box[0], in.box[1]}) + " to " +
               geometry::place_text({in.box[2], in.box[3]});
    }
    std::string operator()(const NodesInCircle& in) const {
        return "circle of radius " + geometry::short_number(1e3 * in.radius) + " mm around " +
               geometry::place_text(in.center);
    }
    std::string operator()(const NodesNearest& near) const {
        return "nearest to " + geometry::place_text(near.points.front()) +
               (near.points.size() > 1 ? " and others" : "");
    }
    std::string operator()(const NodesAtSide& at) const { return side_name(at.side); }
};

class EntryTexts {
  public:
    EntryTexts(const LoadCase& load_case, const Tessellation& tessellation)
        : load_case_(load_case), tessellation_(tessellation) {}

    std::vector<std::string> run() && {
        for (const LoadCase::Support& support : load_case_.supports) {
            std::string held;
            for (std::size_t d = 0; d < mechanics::kDofNames.size(); ++d)
                if (support.fixed.contains[d]) held += std::string(" ") + mechanics::kDofNames[d];
            add("support", picked(support.where), "holds" + held);
        }
        for (const LoadCase::PrescribedDisplacement& entry : load_case_.prescribed)
            add("prescribed", picked(entry.where),
                std::string(mechanics::dof_name(entry.dof)) + " = " + geometry::short_number(entry.value) +
                    (entry.dof < mechanics::Dof::rx ? " m" : " rad"));
        for (const LoadCase::Load& load : load_case_.loads) add_load(load);
        for (const LoadCase::AreaLoad& load : load_case_.area_loads) add_area_load(load);
        if (!load_case_.gravity.isZero(0))
            add("gravity", "all tiles", vector_text(load_case_.gravity) + " m/s2");
        for (const LoadCase::Share& share : load_case_.combines)
            add("combines", share.load_case, geometry::short_number(share.factor) + " times");
        return std::move(lines_);
    }

  private:
    [[nodiscard]] std::string picked(const Selection& where) const {
        return std::visit(SelectionText{}, where) + ": " +
               base::counted(select_nodes(where, tessellation_).size(), "node");
    }

    void add_load(const LoadCase::Load& load) {
        if (load.amount == LoadCase::Amount::PerLength) return add_line_load(load);
        const char* amount = load.amount == LoadCase::Amount::Total ? " in total" : " each";
        std::string what;
        if (!load.force.isZero(0)) what = vector_text(load.force) + " N";
        if (!load.moment.isZero(0)) what += (what.empty() ? "" : ", ") + vector_text(load.moment) + " N m";
        add("load", picked(load.where), what + amount);
    }

    void add_line_load(const LoadCase::Load& load) {
        const auto bearers = detail::line_bearers(load.where, tessellation_);
        double length = 0.0;
        for (const detail::LineBearer& bearer : bearers) length += bearer.length;
        std::string place = "rim between two points";
        if (const auto* at = std::get_if<NodesAtSide>(&load.where)) place = SelectionText{}(*at);
        add("load",
            place + ": " + base::counted(bearers.size(), "node") + " along " +
                geometry::short_number(1e3 * length) + " mm",
            vector_text(load.force) + " N/m");
    }

    void add_area_load(const LoadCase::AreaLoad& load) {
        const auto* where = std::get_if<Selection>(&load.where);
        const auto* tiles = std::get_if<LoadCase::AreaLoad::Tiles>(&load.where);
        const std::string place =
            where != nullptr ? picked(*where) : std::to_string(tiles->numbers.size()) + " tiles by number";
        add("load", place, vector_text(load.per_area) + " N/m2");
    }

    void add(const char* kind, const std::string& where, const std::string& what) {
        char line[32];
        std::snprintf(line, sizeof line, "%-10s ", kind);
        lines_.push_back(line + where + "  " + what);
    }

    const LoadCase& load_case_;
    const Tessellation& tessellation_;
    std::vector<std::string> lines_;
};

class Doubts {
  public:
    Doubts(const LoadCase& load_case, const Surface& surface)
        : load_case_(load_case), surface_(surface), box_(tiling::bounding_box(surface.tessellation)) {}

    std::vector<std::string> run() && {
        for (const auto& entry : load_case_.supports) look_at(entry.where);
        for (const auto& entry : load_case_.loads) look_at(entry.where);
        for (const auto& entry : load_case_.area_loads)
            if (const auto* where = std::get_if<Selection>(&entry.where)) look_at(*where);
        for (const auto& entry : load_case_.prescribed) look_at_prescribed(entry);
        look_at_loads();
        return std::move(doubts_);
    }

  private:
    void look_at(const Selection& where) {
        if (const auto* near = std::get_if<NodesNearest>(&where))
            for (const Point2& point : near->points) look_at(point);
    }

    /// Warn about a point more than two mean tile sides away from all interface nodes.
    void look_at(const Point2& point) {
        double distance = box_.diagonal() + std::hypot(point.x, point.y);
        for (const Point2& node : surface_.tessellation.interface_nodes)
            distance = std::min(distance, std::hypot(node.x - point.x, node.y - point.y));
        if (distance <= 2.0 * tiling::mean_tile_side(surface_.tessellation)) return;
        doubts_.push_back("the point " + geometry::place_text(point) + " lies " +
                          geometry::short_number(distance) + " m away from the surface, which reaches from " +
                          geometry::place_text({box_.xmin, box_.ymin}) + " to " +
                          geometry::place_text({box_.xmax, box_.ymax}) + ": places are in metres");
    }

    void look_at_prescribed(const LoadCase::PrescribedDisplacement& entry) {
        look_at(entry.where);
        const std::string name = mechanics::dof_name(entry.dof);
        if (entry.dof < mechanics::Dof::rx && std::abs(entry.value) > box_.diagonal())
            doubts_.push_back("a prescribed " + name + " of " + geometry::short_number(entry.value) +
                              " m is larger than the surface of " + geometry::short_number(box_.diagonal()) +
                              " m: displacements are in metres");
        if (entry.dof >= mechanics::Dof::rx && std::abs(entry.value) > 2.0 * std::numbers::pi)
            doubts_.push_back("a prescribed " + name + " of " + geometry::short_number(entry.value) +
                              " rad is more than a turn: rotations are in radians");
    }

    /// Compare gravity with the earth's and, if the weight of the surface is known, loads with this weight.
    void look_at_loads() {
        constexpr double kMostGravity = 10.0 * mechanics::kStandardGravity;
        constexpr double kMostWeights = 300.0;
        const double gravity = load_case_.gravity.norm();
        if (gravity > kMostGravity)
            doubts_.push_back("a gravity of " + geometry::short_number(gravity) +
                              " m/s2 is more than ten times the earth's");
        const auto is_painted = [](const tiling::Tile& tile) { return tile.pattern >= 0; };
        if (surface_.setting.material.density == 0.0 || !load_case_.combines.empty() ||
            !std::ranges::all_of(surface_.tessellation.tiles, is_painted))
            return;
        const auto masses = tile_masses(surface_);
        const double weight =
            mechanics::kStandardGravity * std::accumulate(masses.begin(), masses.end(), 0.0);
        LoadCase applied = load_case_;
        applied.gravity.setZero();
        double force = 0.0;
        for (const mechanics::NodalLoad& load : resolve(applied, surface_, {}).loads)
            force += load.force.norm();
        if (force > kMostWeights * weight)
            doubts_.push_back("loads of " + geometry::short_number(force) + " N in all are " +
                              geometry::short_number(std::round(force / weight)) +
                              " times the surface's weight: forces are in newtons");
    }

    const LoadCase& load_case_;
    const Surface& surface_;
    geometry::Box box_;
    std::vector<std::string> doubts_;
};

}  // namespace

std::vector<std::string> entry_texts(const LoadCase& load_case, const Tessellation& tessellation) {
    check_selections(load_case, tessellation);
    return EntryTexts(load_case, tessellation).run();
}

std::vector<std::string> warnings_about(const LoadCase& load_case, const Surface& surface) {
    return Doubts(load_case, surface).run();
}

}  // namespace fretwork::simulation

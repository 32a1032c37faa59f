// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/drawings/detail/surface_parts.hpp>
#include <fretwork/exports/space/bar_scene.hpp>
#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::exports {
namespace {

using simulation::SurfaceBeams;

constexpr double kMillimetres = 1e3;
constexpr double kMegapascals = 1e-6;

struct FieldRow {
    const char* name;
    const char* title;
    const char* unit;
    double factor;
    /// The value of the field from the columns of kBeamFields.
    double (*value)(const Eigen::RowVector<double, 8>& forces);
};
constexpr std::array<FieldRow, 5> kForceFields = {{
    {"von_mises", "Largest von Mises stress", "MPa", kMegapascals,
     [](const auto& f) { return f[simulation::kVonMisesField]; }},
    {"stress", "Largest normal stress", "MPa", kMegapascals,
     [](const auto& f) { return f[simulation::kStressField]; }},
    {"bending", "Bending moment", "N mm", kMillimetres, [](const auto& f) { return std::hypot(f[4], f[5]); }},
    {"torsion", "Torsion", "N mm", kMillimetres, [](const auto& f) { return f[3]; }},
    {"axial", "Axial force", "N", 1.0, [](const auto& f) { return f[0]; }},
}};
constexpr const char* kDisplacement = "displacement";

class Builder {
  public:
    explicit Builder(const Scene& scene) : scene_(scene), beams_(simulation::surface_beams(scene.surface)) {}

    BarScene build() && {
        const mechanics::Section& section = scene_.surface.setting.section;
        bars_.width = mechanics::section_width(section);
        bars_.height = mechanics::section_height(section);
        bars_.joints = scene_.surface.setting.joints;
        bars_.nodes = beams_.nodes;
        if (!scene_.results.empty()) {
            const auto sections = simulation::beam_sections(beams_, scene_.surface.setting);
            state_ = simulation::beam_state(scene_.surface, scene_.results.front().result, beams_, sections,
                                            scene_.models);
        } else {
            state_.nodes.setZero(std::ssize(beams_.nodes), mechanics::kDofsPerNode);
        }
        for (std::size_t t = 0; t + 1 < beams_.starts.size(); ++t) add_tile(t);
        bars_.motion = state_.nodes.array().isNaN().select(0.0, state_.nodes);
        if (!scene_.results.empty()) add_fields();
        add_conditions();
        add_title();
        return std::move(bars_);
    }

  private:
    [[nodiscard]] bool is_known(std::size_t tile) const {
        const Eigen::Index first = beams_.starts[tile].inner_node;
        const Eigen::Index count = beams_.starts[tile + 1].inner_node - first;
        return !state_.nodes.middleRows(first, count).hasNaN();
    }

    void add_tile(std::size_t t) {
        const tiling::Tile& tile = scene_.surface.tessellation.tiles[t];
        if (is_known(t)) {
            for (std::size_t b = beams_.starts[t].beam; b < beams_.starts[t + 1].beam; ++b) {
                add_bar({beams_.ends[b][0].value, beams_.ends[b][1].value}, tile.pattern);
                beam_of_bar_.push_back(b);
            }
            return;
        }
        const std::size_t sides = tile.interface_nodes.size();
        for (std::size_t k = 0; k < sides; ++k) {
            add_bar({tile.interface_nodes[k].value, tile.interface_nodes[(k + 1) % sides].value},
                    tile.pattern);
            beam_of_bar_.push_back(-1);
        }
    }

    void add_bar(std::array<int, 2> ends, int pattern) {
        bars_.bars.push_back(ends);
        bars_.patterns.push_back(pattern);
    }

    void add_fields() {
        BarScene::Field displacement{kDisplacement, "Displacement", "mm", kMillimetres, {}};
        for (const auto& ends : bars_.bars) {
            for (const int node : ends)
                displacement.values.push_back(bars_.motion.row(node).head<3>().norm());
        }
        bars_.fields.push_back(std::move(displacement));
        for (const FieldRow& row : kForceFields) {
            BarScene::Field field{row.name, row.title, row.unit, row.factor, {}};
            for (const std::ptrdiff_t beam : beam_of_bar_) {
                for (const std::ptrdiff_t end : {0, 1})
                    field.values.push_back(beam < 0 ? std::nan("")
                                                    : row.value(state_.forces.row(2 * beam + end)));
            }
            bars_.fields.push_back(std::move(field));
        }
        if (!scene_.known_strength()) return;
        BarScene::Field field = bars_.fields[1];  // the von Mises stress
        field.name = kUtilization;
        field.title = "Share of the strength";
        field.unit = "%";
        field.factor = 100.0;
        for (double& value : field.values) value /= *scene_.known_strength();
        bars_.fields.push_back(std::move(field));
    }

    void add_conditions() {
        if (!scene_.conditions) return;
        for (const mechanics::Support& support : detail::supports_of_nodes(*scene_.conditions)) {
            using Kind = BarScene::Support::Kind;
            const bool is_clamped = support.fixed == mechanics::DofSet::all();
            const bool is_pinned = support.fixed == mechanics::DofSet::translations();
            bars_.supports.push_back(
                {support.node.value, is_clamped ? Kind::Clamped : (is_pinned ? Kind::Pinned : Kind::Other)});
        }
        const auto nodes = scene_.surface.tessellation.interface_nodes.size();
        const mechanics::NodeValues rows = simulation::load_rows(*scene_.conditions, nodes);
        for (int node = 0; node < static_cast<int>(nodes); ++node) {
            const auto row = rows.row(node);
            if (!row.isZero(0.0))
                bars_.loads.push_back({node, row.head<3>().transpose(), row.tail<3>().transpose()});
        }
    }

    void add_title() {
        bars_.title = base::counted(scene_.surface.tessellation.tiles.size(), "tile");
        if (scene_.results.empty()) return;
        const auto& result = scene_.results.front();
        const auto& subject = result.result.subject;
        bars_.title += ", " + (subject ? subject->model : result.label);
        if (subject) bars_.title += ", " + subject->load_case;
    }

    const Scene& scene_;
    SurfaceBeams beams_;
    simulation::BeamState state_;
    std::vector<std::ptrdiff_t> beam_of_bar_;  ///< -1: none
    BarScene bars_;
};

}  // namespace

BarScene make_bar_scene(const Scene& scene) {
    if (!scene.results.empty()) require_same_surface(scene.surface, scene.results.front().result);
    return Builder(scene).build();
}

std::vector<std::string> bar_field_names() {
    std::vector<std::string> names = {kDisplacement};
    for (const FieldRow& row : kForceFields) names.emplace_back(row.name);
    names.emplace_back(kUtilization);
    return names;
}

Eigen::Vector3d place_of(const BarScene& scene, int node, double scale) {
    return scene.nodes[node] + scale * scene.motion.row(node).head<3>().transpose();
}

}  // namespace fretwork::exports

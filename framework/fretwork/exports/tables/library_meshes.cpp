// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/task.hpp>
#include <fretwork/exports/tables/library_meshes.hpp>
#include <fretwork/exports/tables/line_files.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/ring/paper6_tile.hpp>

namespace fretwork::exports {

LineSet pattern_lines(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                      const reduction::Setting& setting) {
    const pattern::Fan fan = make_fan(layout, pattern, setting.sides);
    const geometry::Polygon polygon = geometry::regular_polygon(setting.sides, setting.tile_side);
    LineSet lines;
    for (const geometry::Point2& node : place_fan(layout, fan, polygon))
        lines.nodes.emplace_back(node.x, node.y, 0.0);
    for (const auto& edge : fan.edges) lines.lines.push_back({edge[0].value, edge[1].value});
    return lines;
}

std::size_t export_meshes(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                          const std::filesystem::path& folder, const MeshOptions& options) {
    base::FolderBatch files(folder);
    const std::size_t count = add_meshes(library, patterns, options, files);
    files.commit();
    return count;
}

std::size_t add_meshes(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                       const MeshOptions& options, base::FolderBatch& batch) {
    const std::string ending = options.kind == MeshKind::Obj ? ".obj" : ".ply";
    const base::Task task(options.control, "meshes", patterns.size());
    std::size_t files = 0;
    const auto write = [&](const std::string& name, const LineSet& lines) {
        batch.add(name + ending, options.kind == MeshKind::Obj ? obj_text(lines) : ply_text(lines));
        ++files;
    };
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        options.control.check();
        task.update(i);
        const pattern::NamedPattern& entry = patterns[i];
        write(entry.id, pattern_lines(library.layout(), entry.pattern, library.setting()));
        for (const reduction::Calibration& best : library.best_calibrations(entry.id)) {
            if (best.parameters.empty()) continue;  // its beams, if it has any, are the pattern's
            write(entry.id + "." + best.model,
                  model_lines(library.layout(), entry.pattern, best, library.setting(), options.models));
        }
    }
    return files;
}

}  // namespace fretwork::exports

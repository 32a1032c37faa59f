// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/space/detail/camera.hpp>
#include <fretwork/exports/space/detail/start_view.hpp>

namespace fretwork::exports::detail {

ViewOptions start_view(const BarScene& bars, const Scene& scene) {
    if (scene.view) return *scene.view;
    std::vector<std::vector<Eigen::Vector3d>> faces;
    std::vector<Eigen::Vector3d> moves;
    for (const tiling::Tile& tile : scene.surface.tessellation.tiles) {
        std::vector<Eigen::Vector3d>& face = faces.emplace_back();
        for (const tiling::InterfaceIndex node : tile.interface_nodes) {
            face.push_back(place_of(bars, node.value, scene.displacement_scale));
            moves.emplace_back(bars.motion.row(node.value).head<3>());
        }
    }
    return best_view(faces, moves);
}

}  // namespace fretwork::exports::detail

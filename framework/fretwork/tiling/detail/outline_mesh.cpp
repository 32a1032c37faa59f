// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/tiling/detail/outline_readers.hpp>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <algorithm>
#include <cmath>

namespace fretwork::tiling::detail {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

/// OpenMesh writes warnings to a stream of its own; here an exception says what is wrong.
class QuietOpenMesh {
  public:
    QuietOpenMesh() : was_enabled_(omerr().is_enabled()) { omerr().disable(); }
    ~QuietOpenMesh() {
        if (was_enabled_) omerr().enable();
    }
    QuietOpenMesh(const QuietOpenMesh&) = delete;
    QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

  private:
    bool was_enabled_;
};

Mesh read_mesh(const std::filesystem::path& path) {
    base::read_text_file(path);  // a missing file is told as everywhere
    const QuietOpenMesh quiet;
    Mesh mesh;
    OpenMesh::IO::Options options;
    if (!OpenMesh::IO::read_mesh(mesh, path.string(), options))
        throw base::InputError(path.string(), "", "is no mesh that can be read");
    if (mesh.n_faces() == 0) throw base::InputError(path.string(), "", "has no face");
    return mesh;
}

/// All points must be finite and have the same z, but for rounding.
void check_flat(const Mesh& mesh, const std::filesystem::path& path) {
    OpenMesh::Vec3d low(std::numeric_limits<double>::infinity());
    OpenMesh::Vec3d high(-std::numeric_limits<double>::infinity());
    for (const auto vertex : mesh.vertices()) {
        const OpenMesh::Vec3d point = mesh.point(vertex);
        if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || !std::isfinite(point[2]))
            throw base::InputError(path.string(), "vertex " + std::to_string(vertex.idx()), "is not finite");
        low.minimize(point);
        high.maximize(point);
    }
    constexpr double kFlat = 1e-6;  // of the size: what single-precision files can hold
    const double size = std::max(high[0] - low[0], high[1] - low[1]);
    for (const auto vertex : mesh.vertices()) {
        if (const double z = mesh.point(vertex)[2]; std::abs(z - low[2]) > kFlat * size)
            throw base::GeometryError(path.string(), "vertex " + std::to_string(vertex.idx()),
                                      "the surface is not flat: z is " + base::format_number(z) +
                                          ", and elsewhere " + base::format_number(low[2]));
    }
}

void check_one_piece(const Mesh& mesh, const std::filesystem::path& path) {
    std::vector<bool> seen(mesh.n_faces(), false);
    std::vector<OpenMesh::FaceHandle> open{OpenMesh::FaceHandle(0)};
    seen[0] = true;
    std::size_t count = 0;
    while (!open.empty()) {
        const OpenMesh::FaceHandle face = open.back();
        open.pop_back();
        ++count;
        for (const auto neighbor : mesh.ff_range(face)) {
            if (seen[static_cast<std::size_t>(neighbor.idx())]) continue;
            seen[static_cast<std::size_t>(neighbor.idx())] = true;
            open.push_back(neighbor);
        }
    }
    if (count == mesh.n_faces()) return;
    const auto face = std::find(seen.begin(), seen.end(), false) - seen.begin();
    throw base::GeometryError(path.string(), "face " + std::to_string(face),
                              "the surface is not one piece: this face does not hang together with face 0");
}

}  // namespace

std::vector<Loop> read_mesh_loops(const std::filesystem::path& path) {
    const Mesh mesh = read_mesh(path);
    check_flat(mesh, path);
    check_one_piece(mesh, path);
    std::vector<Loop> loops;
    std::vector<bool> done(mesh.n_halfedges(), false);
    for (const auto first : mesh.halfedges()) {
        if (!mesh.is_boundary(first) || done[static_cast<std::size_t>(first.idx())]) continue;
        Loop loop;
        loop.place = "the rim at vertex " + std::to_string(mesh.to_vertex_handle(first).idx());
        OpenMesh::HalfedgeHandle h = first;
        do {
            done[static_cast<std::size_t>(h.idx())] = true;
            const OpenMesh::Vec3d point = mesh.point(mesh.to_vertex_handle(h));
            loop.points.push_back({point[0], point[1]});
            h = mesh.next_halfedge_handle(h);
        } while (h != first);
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace fretwork::tiling::detail

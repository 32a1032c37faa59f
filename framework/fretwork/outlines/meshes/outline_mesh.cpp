// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/detail/outline_readers.hpp>
#include <fretwork/outlines/meshes/mesh_text.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <algorithm>
#include <array>
#include <cmath>

namespace fretwork::outlines::detail {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

/// Silences OpenMesh, which writes warnings to its own stream; an exception reports the error instead.
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

/// Check that all points have the same z, up to rounding.
void check_flat(const MeshFile& file, const std::filesystem::path& path) {
    if (file.faces.empty()) throw base::InputError(path.string(), "", "has no face");
    std::array<double, 3> low = file.points.front();
    std::array<double, 3> high = low;
    for (const auto& point : file.points) {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    }
    constexpr double kFlat = 1e-6;  // share of the size, the precision of single-precision files
    const double size = std::max(high[0] - low[0], high[1] - low[1]);
    for (std::size_t vertex = 0; vertex < file.points.size(); ++vertex) {
        if (const double z = file.points[vertex][2]; std::abs(z - low[2]) > kFlat * size)
            throw base::GeometryError(path.string(), "vertex " + std::to_string(vertex),
                                      "the surface is not flat: z is " + base::format_number(z) +
                                          ", and elsewhere " + base::format_number(low[2]));
    }
}

Mesh make_mesh(const MeshFile& file, const std::filesystem::path& path) {
    const QuietOpenMesh quiet;
    Mesh mesh;
    for (const auto& [x, y, z] : file.points) mesh.add_vertex({x, y, z});
    for (std::size_t face = 0; face < file.faces.size(); ++face) {
        std::vector<OpenMesh::VertexHandle> vertices;
        for (const int vertex : file.faces[face]) vertices.emplace_back(vertex);
        if (!mesh.add_face(vertices).is_valid())
            throw base::GeometryError(
                path.string(), "face " + std::to_string(face),
                "does not fit the faces before it: at most two faces may share a side, and they must "
                "run along it in opposite directions");
    }
    return mesh;
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
            if (seen[neighbor.idx()]) continue;
            seen[neighbor.idx()] = true;
            open.push_back(neighbor);
        }
    }
    if (count == mesh.n_faces()) return;
    const auto face = std::find(seen.begin(), seen.end(), false) - seen.begin();
    throw base::GeometryError(path.string(), "face " + std::to_string(face),
                              "the surface is not one piece: this face is not connected to face 0");
}

std::vector<Loop> loops_of_mesh(const std::filesystem::path& path, const MeshFile& file) {
    check_flat(file, path);
    const Mesh mesh = make_mesh(file, path);
    check_one_piece(mesh, path);
    std::vector<Loop> loops;
    std::vector<bool> done(mesh.n_halfedges(), false);
    for (const auto first : mesh.halfedges()) {
        if (!mesh.is_boundary(first) || done[first.idx()]) continue;
        Loop loop;
        loop.place = "the rim at vertex " + std::to_string(mesh.to_vertex_handle(first).idx());
        OpenMesh::HalfedgeHandle h = first;
        do {
            done[h.idx()] = true;
            const OpenMesh::Vec3d point = mesh.point(mesh.to_vertex_handle(h));
            loop.points.push_back({point[0], point[1]});
            h = mesh.next_halfedge_handle(h);
        } while (h != first);
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace

std::vector<Loop> read_obj_loops(const std::filesystem::path& path) {
    return loops_of_mesh(path, read_obj(path));
}
std::vector<Loop> read_off_loops(const std::filesystem::path& path) {
    return loops_of_mesh(path, read_off(path));
}
std::vector<Loop> read_ply_loops(const std::filesystem::path& path) {
    return loops_of_mesh(path, read_ply(path));
}

}  // namespace fretwork::outlines::detail

namespace fretwork::outlines {

void check_mesh_ending(const std::filesystem::path& path) {
    const std::string ending = base::ending_of(path);
    if (ending != ".obj" && ending != ".ply" && ending != ".off")
        throw base::InputError(path.string(), "",
                               "a mesh is an .obj, .ply or .off file, and this ends in '" + ending + "'");
}

MeshFile read_space_mesh(const std::filesystem::path& path) {
    using namespace detail;
    check_mesh_ending(path);
    const std::string ending = base::ending_of(path);
    MeshFile file = ending == ".obj" ? read_obj(path) : ending == ".ply" ? read_ply(path) : read_off(path);
    if (file.faces.empty()) throw base::InputError(path.string(), "", "has no face");
    return file;
}

MeshFile read_flat_mesh(const std::filesystem::path& path) {
    MeshFile file = read_space_mesh(path);
    detail::check_flat(file, path);
    return file;
}

}  // namespace fretwork::outlines

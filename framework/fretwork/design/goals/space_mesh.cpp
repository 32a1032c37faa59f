// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/goals/space_mesh.hpp>
#include <fretwork/outlines/flat_mesh.hpp>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace fretwork::design::detail {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using MeshPoint = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Eigen::Vector3d vector_of(const MeshPoint& point) {
    return {point.x(), point.y(), point.z()};
}

/// Faces of more than three sides are split into triangles.
Triangles triangles_of(const outlines::MeshFile& mesh) {
    const auto point = [&mesh](int vertex) {
        const auto& place = mesh.points[static_cast<std::size_t>(vertex)];
        return MeshPoint(place[0], place[1], place[2]);
    };
    Triangles triangles;
    for (const std::vector<int>& face : mesh.faces) {
        for (std::size_t i = 2; i < face.size(); ++i) {
            const Triangle triangle(point(face[0]), point(face[i - 1]), point(face[i]));
            if (!triangle.is_degenerate()) triangles.push_back(triangle);
        }
    }
    return triangles;
}

}  // namespace

class SpaceMesh::Impl {
  public:
    explicit Impl(Triangles triangles)
        : triangles_(std::move(triangles)), tree_(triangles_.begin(), triangles_.end()) {
        tree_.build();
    }
    [[nodiscard]] Nearest nearest(const Eigen::Vector3d& point) const {
        const auto [place, triangle] =
            tree_.closest_point_and_primitive(MeshPoint(point.x(), point.y(), point.z()));
        const Eigen::Vector3d a = vector_of(triangle->vertex(0));
        const Eigen::Vector3d normal =
            (vector_of(triangle->vertex(1)) - a).cross(vector_of(triangle->vertex(2)) - a);
        return {vector_of(place), normal.normalized()};
    }

  private:
    Triangles triangles_;
    Tree tree_;
};

SpaceMesh::SpaceMesh(const std::filesystem::path& path) {
    Triangles triangles = triangles_of(outlines::read_space_mesh(path));
    if (triangles.empty())
        throw base::InputError(path.string(), "", "is not a surface: the area of every face is zero");
    impl_ = std::make_unique<Impl>(std::move(triangles));
}
SpaceMesh::~SpaceMesh() = default;

SpaceMesh::Nearest SpaceMesh::nearest(const Eigen::Vector3d& point) const {
    return impl_->nearest(point);
}

}  // namespace fretwork::design::detail

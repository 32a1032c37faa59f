// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/outlines/meshes/mesh_text.hpp>

namespace fretwork::outlines::detail {
namespace {

/// A face, and the number of vertices before it in the file, from which negative numbers count back.
struct ObjFace {
    TextLine line;
    std::size_t vertices_before;
};

/// The index, from 0, of the vertex of a corner such as "3", "-1" or "3/2/1". Files number vertices from 1.
long long vertex_of(const MeshText& text, const ObjFace& face, std::string_view corner, std::size_t count) {
    const long long number = text.whole_number(face.line, corner.substr(0, corner.find('/')));
    const auto before = static_cast<long long>(face.vertices_before);
    const bool is_there = number > 0 ? number <= static_cast<long long>(count) : number >= -before;
    if (number == 0 || !is_there)
        text.fail(face.line, "the face names the vertex " + std::to_string(number) + ", where 1 to " +
                                 std::to_string(count) + " are there (or -1, -2, .. for those before)");
    return number > 0 ? number - 1 : before + number;
}

}  // namespace

MeshFile read_obj(const std::filesystem::path& path) {
    MeshText text(path);
    MeshFile mesh;
    std::vector<ObjFace> faces;
    while (const auto line = text.next_line()) {
        if (line->words.front() == "v") mesh.points.push_back(text.point(*line, 1));
        if (line->words.front() == "f") faces.push_back({*line, mesh.points.size()});
    }
    for (const ObjFace& face : faces) {
        std::vector<long long> vertices;
        for (std::size_t i = 1; i < face.line.words.size(); ++i)
            vertices.push_back(vertex_of(text, face, face.line.words[i], mesh.points.size()));
        text.add_face("line " + std::to_string(face.line.number), vertices, mesh.points.size(), mesh);
    }
    return mesh;
}

}  // namespace fretwork::outlines::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/outlines/meshes/mesh_text.hpp>

#include <algorithm>

namespace fretwork::outlines::detail {
namespace {

/// Read the numbers of vertices, faces and edges, which follow the keyword on its line or on the next line. A
/// prefix of the keyword adds values to each vertex (texture, colour, normal); they follow the coordinates
/// and are skipped.
TextLine read_header(MeshText& text) {
    TextLine line = text.need_line("the keyword OFF");
    constexpr std::array<std::string_view, 8> kKeywords = {"OFF",   "COFF",   "NOFF",   "CNOFF",
                                                           "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
    if (std::find(kKeywords.begin(), kKeywords.end(), line.words.front()) == kKeywords.end())
        text.fail(line, "begins with '" + std::string(line.words.front()) +
                            "', where a plain OFF file begins with OFF");
    if (line.words.size() > 1 && line.words[1] == "BINARY")
        text.fail(line, "is binary, where an ASCII OFF file is needed");
    line.words.erase(line.words.begin());
    if (line.words.empty()) line = text.need_line("the numbers of vertices, faces and edges");
    if (line.words.size() < 2) text.fail(line, "has no numbers of vertices and faces");
    return line;
}

std::vector<long long> read_face(const MeshText& text, const TextLine& line) {
    const long long count = text.whole_number(line, line.words.front());
    const auto given = static_cast<long long>(line.words.size()) - 1;
    if (count < 0 || count > given)
        text.fail(line, "the face promises " + std::string(line.words.front()) + " vertices, and has " +
                            std::to_string(given));
    std::vector<long long> vertices;
    for (long long i = 1; i <= count; ++i) vertices.push_back(text.whole_number(line, line.words[i]));
    return vertices;
}

std::string which(const std::string& thing, std::size_t i, std::size_t count) {
    return thing + " " + std::to_string(i) + " of " + std::to_string(count) + " (from 0 on)";
}

}  // namespace

MeshFile read_off(const std::filesystem::path& path) {
    MeshText text(path);
    const TextLine header = read_header(text);
    const std::size_t vertices = text.count(header, header.words[0], "vertices");
    const std::size_t faces = text.count(header, header.words[1], "faces");
    MeshFile mesh;
    for (std::size_t i = 0; i < vertices; ++i)
        mesh.points.push_back(text.point(text.need_line(which("vertex", i, vertices)), 0));
    for (std::size_t i = 0; i < faces; ++i) {
        const TextLine line = text.need_line(which("face", i, faces));
        text.add_face("line " + std::to_string(line.number), read_face(text, line), vertices, mesh);
    }
    return mesh;
}

}  // namespace fretwork::outlines::detail

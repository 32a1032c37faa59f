// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/outlines/meshes/mesh_text.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::outlines::detail {
namespace {

/// The largest number of faces, which take a second to read: more than a simulated surface of tiles can have,
/// and far more than the rim of an outline needs.
constexpr std::size_t kMostFaces = 250'000;

std::string too_many_faces() {
    return "the mesh has more than " + std::to_string(kMostFaces) + " faces; make it coarser";
}

std::string place_of(const TextLine& line) {
    return "line " + std::to_string(line.number);
}

std::string quoted(std::string_view word) {
    return "'" + std::string(word) + "'";
}

std::vector<std::string_view> words_of(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\f\v";
    text = text.substr(0, text.find('#'));
    std::vector<std::string_view> words;
    for (auto first = text.find_first_not_of(kSpace); first != std::string_view::npos;) {
        const auto end = std::min(text.find_first_of(kSpace, first), text.size());
        words.push_back(text.substr(first, end - first));
        first = text.find_first_not_of(kSpace, end);
    }
    return words;
}

}  // namespace

MeshText::MeshText(const std::filesystem::path& path)
    : source_(path.string()), text_(base::read_text_file(path)) {}

std::optional<TextLine> MeshText::next_line() {
    while (next_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', next_), text_.size());
        TextLine line{++line_, words_of(std::string_view(text_).substr(next_, end - next_))};
        next_ = std::min(end + 1, text_.size());
        if (!line.words.empty()) return line;
    }
    return std::nullopt;
}

TextLine MeshText::need_line(const std::string& wanted) {
    if (auto line = next_line()) return *line;
    throw base::InputError(source_, "line " + std::to_string(line_ + 1), "the file ends before " + wanted);
}

void MeshText::fail(const std::string& place, const std::string& message) const {
    throw base::InputError(source_, place, message);
}
void MeshText::fail(const TextLine& line, const std::string& message) const {
    fail(place_of(line), message);
}

double MeshText::number(const TextLine& line, std::string_view word) const {
    const auto value = base::read_number<double>(word);
    if (!value || !std::isfinite(*value)) fail(line, quoted(word) + " is not a finite number");
    return *value;
}

long long MeshText::whole_number(const TextLine& line, std::string_view word) const {
    const auto value = base::read_number<long long>(word);
    if (!value) fail(line, quoted(word) + " is not a whole number");
    return *value;
}

std::size_t MeshText::count(const TextLine& line, std::string_view word, const std::string& things) const {
    const long long value = whole_number(line, word);
    if (value < 0) fail(line, quoted(word) + " is not a number of " + things);
    if (value > std::ssize(text_))
        fail(line, "promises " + std::string(word) + " " + things + ", and the file has " +
                       std::to_string(text_.size()) + " bytes");
    if (things == "faces" && std::cmp_greater(value, kMostFaces)) fail(line, too_many_faces());
    return value;
}

std::array<double, 3> MeshText::point(const TextLine& line, std::size_t first) const {
    const std::size_t given = line.words.size() - first;
    if (given < 3) fail(line, "the vertex has " + std::to_string(given) + " coordinates, where 3 are needed");
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i) point[i] = number(line, line.words[first + i]);
    return point;
}

void MeshText::add_face(const std::string& place, const std::vector<long long>& vertices,
                        std::size_t vertex_count, MeshFile& mesh) const {
    if (mesh.faces.size() >= kMostFaces) fail(place, too_many_faces());
    if (vertices.size() < 3)
        fail(place,
             "the face has " + std::to_string(vertices.size()) + " vertices, where at least 3 are needed");
    std::vector<int> face;
    for (const long long vertex : vertices) {
        if (!std::in_range<std::size_t>(vertex) || std::cmp_greater_equal(vertex, vertex_count))
            fail(place, "the face names the vertex " + std::to_string(vertex) + ", and there are " +
                            std::to_string(vertex_count) + " (from 0 on)");
        face.push_back(static_cast<int>(vertex));
    }
    std::vector<int> sorted = face;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
        fail(place, "the face has the vertex " + std::to_string(*twice) + " (from 0 on) twice");
    mesh.faces.push_back(std::move(face));
}

}  // namespace fretwork::outlines::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/outlines/flat_mesh.hpp>

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Meshes as OBJ, PLY and OFF files hold them. We read these simple formats strictly by ourselves: a file is
/// refused with line and value, no count is believed before the file has shown what it counts, and nothing is
/// left out in silence.
namespace fretwork::outlines::detail {

MeshFile read_obj(const std::filesystem::path& path);
MeshFile read_off(const std::filesystem::path& path);
/// ASCII, or binary of either byte order.
MeshFile read_ply(const std::filesystem::path& path);

/// The words of a line of text, and its number, from 1.
struct TextLine {
    std::size_t number = 0;
    std::vector<std::string_view> words;
};

/// A walk through a mesh file.
class MeshText {
  public:
    /// Throws InputError if the file cannot be read.
    explicit MeshText(const std::filesystem::path& path);

    /// The next line that has words; what stands behind # is left out.
    std::optional<TextLine> next_line();
    /// The next line; `wanted` says what the file lacks if it ends here.
    TextLine need_line(const std::string& wanted);
    /// All bytes behind the last line.
    [[nodiscard]] std::string_view rest() const { return std::string_view(text_).substr(next_); }
    [[nodiscard]] std::size_t size() const { return text_.size(); }

    [[noreturn]] void fail(const std::string& place, const std::string& message) const;
    [[noreturn]] void fail(const TextLine& line, const std::string& message) const;

    /// A finite number.
    [[nodiscard]] double number(const TextLine& line, std::string_view word) const;
    [[nodiscard]] long long whole_number(const TextLine& line, std::string_view word) const;
    /// How many of something the file says there are: not below zero, and no more than bytes in the file.
    [[nodiscard]] std::size_t count(const TextLine& line, std::string_view word,
                                    const std::string& things) const;
    /// The first three words from `first` on, as a place.
    [[nodiscard]] std::array<double, 3> point(const TextLine& line, std::size_t first) const;

    /// Check a face whose vertices are numbered from 0 and add it to the mesh.
    void add_face(const std::string& place, const std::vector<long long>& vertices, std::size_t vertex_count,
                  MeshFile& mesh) const;

  private:
    std::string source_;
    std::string text_;
    std::size_t next_ = 0;
    std::size_t line_ = 0;
};

}  // namespace fretwork::outlines::detail

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

/// Strict readers of OBJ, PLY and OFF files. An error names the line (in a binary PLY, the vertex or face)
/// and what is wrong. A count in a file is not trusted before that number of items was read. All data other
/// than positions and faces are skipped.
namespace fretwork::outlines::detail {

MeshFile read_obj(const std::filesystem::path& path);
MeshFile read_off(const std::filesystem::path& path);
/// Read a PLY file, in ASCII or binary with either byte order.
MeshFile read_ply(const std::filesystem::path& path);

/// The words of a line of text, and the line's number, from 1.
struct TextLine {
    std::size_t number = 0;
    std::vector<std::string_view> words;
};

/// A reader that goes through a mesh file line by line.
class MeshText {
  public:
    /// Read the text of a file. Throws InputError if the file cannot be read.
    explicit MeshText(const std::filesystem::path& path);

    /// The next line that has words; nothing at the end of the file. Text after # is skipped.
    std::optional<TextLine> next_line();
    /// The next line that has words. Throws InputError if there is none; the message says that `wanted` is
    /// missing.
    TextLine need_line(const std::string& wanted);
    /// All bytes after the last line read.
    [[nodiscard]] std::string_view rest() const { return std::string_view(text_).substr(next_); }
    [[nodiscard]] std::size_t size() const { return text_.size(); }

    [[noreturn]] void fail(const std::string& place, const std::string& message) const;
    [[noreturn]] void fail(const TextLine& line, const std::string& message) const;

    /// The value of a word, which must be a finite number.
    [[nodiscard]] double number(const TextLine& line, std::string_view word) const;
    [[nodiscard]] long long whole_number(const TextLine& line, std::string_view word) const;
    /// The number of `things` that the file states. Throws InputError if this is not a whole number, or if it
    /// is below zero, above the number of bytes in the file or, for "faces", above 250,000.
    [[nodiscard]] std::size_t count(const TextLine& line, std::string_view word,
                                    const std::string& things) const;
    /// The point given by three words, starting with word `first`.
    [[nodiscard]] std::array<double, 3> point(const TextLine& line, std::size_t first) const;

    /// Check a face and add it to the mesh. `vertices` are indices of points, counted from 0. Throws
    /// InputError with `place` if the face is not as MeshFile::faces requires, or is one too many.
    void add_face(const std::string& place, const std::vector<long long>& vertices, std::size_t vertex_count,
                  MeshFile& mesh) const;

  private:
    std::string source_;
    std::string text_;
    std::size_t next_ = 0;
    std::size_t line_ = 0;
};

}  // namespace fretwork::outlines::detail

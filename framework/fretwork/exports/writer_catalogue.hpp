// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/scene.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::exports {

/// The kind of content of a file.
enum class Content {
    Drawing,      ///< a drawing for people
    Centrelines,  ///< the beams as lines, with fields
    Cut,          ///< the true outline, for machines that cut
    Solid,        ///< the extruded outline, for machines that print
    Facts,        ///< the facts for a maker: masses, lengths, narrow places, stresses
};
/// The name of a content on the command line, such as "cut".
std::string_view content_name(Content content);
/// The content with this name. Throws InputError that suggests the nearest name, or lists all names.
Content parse_content(const std::string& name);

/// The text of a file, and remarks, one line each, about options for making that could not be met.
struct Written {
    std::string text;                    ///< content of the file
    std::vector<std::string> remarks{};  ///< remarks, one line each
};

/// A row of the catalogue: a kind of file.
struct WriterRow {
    std::string_view ending;         ///< file extension with its dot
    Content content;                 ///< content; it distinguishes rows with the same file extension
    std::string_view description;    ///< description in `--help`
    Written (*write)(const Scene&);  ///< function that makes the text
    /// The members of a scene that a writer reads besides surface, results, models and control.
    enum class Kind {
        Data,     ///< no further members; .vtu: the strength
        Drawing,  ///< conditions, scale, view and labels
        Picture,  ///< conditions, scale, view, strength and Scene::picture
        Motion,   ///< scale, strength and Scene::picture; the file moves through the load steps of a result
        Made      ///< Scene::making; facts: also the load case
    };
    Kind kind = Kind::Data;  ///< kind of members
    /// True if the file is a drawing, a picture or a motion. Each reads the scale.
    [[nodiscard]] bool is_drawing() const { return kind == Kind::Drawing || is_picture(); }
    /// True if the writer also reads Scene::picture.
    [[nodiscard]] bool is_picture() const { return kind == Kind::Picture || moves(); }
    /// True if the file moves from rest through the load steps of the first result.
    [[nodiscard]] bool moves() const { return kind == Kind::Motion; }
    /// True if the writer reads Scene::view.
    [[nodiscard]] bool has_view() const { return is_drawing() && !moves(); }
    /// True if the writer reads Scene::making.
    [[nodiscard]] bool is_made() const { return kind == Kind::Made; }
    /// True if the file depends on the results of a scene; other files show the surface as it is made.
    [[nodiscard]] bool shows_results() const { return !is_made() || content == Content::Facts; }
};

/// The unit of lengths in the files of a writer: "millimetre", "metre", or "none" for pictures and pages.
std::string_view unit_of(const WriterRow& writer);

/// All kinds of files. A new kind needs a source file and a row.
std::span<const WriterRow> writer_catalogue();
/// The writer for a file extension and a content. Without `content`, the result is the first writer for this
/// extension. Throws InputError that suggests the nearest extension or lists all, or lists the contents that
/// the extension can have.
const WriterRow& find_writer(const std::filesystem::path& path, std::optional<Content> content = {});
/// True if a writer is the first with its file extension: the default without a given content.
bool is_default(const WriterRow& writer);

}  // namespace fretwork::exports

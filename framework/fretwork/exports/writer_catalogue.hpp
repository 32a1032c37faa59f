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
    Drawing,      ///< for people
    Centrelines,  ///< the beams as lines, with their fields
    Cut,          ///< the true outline, for machines that cut
    Solid,        ///< the extruded outline, for machines that print
    Facts,        ///< the facts for a maker: masses, lengths, narrow places, stresses
};
/// The name of a content on the command line: "cut".
std::string_view content_name(Content content);
/// The content with this name. Throws InputError that lists the names.
Content parse_content(const std::string& name);

/// The text of a file, and remarks, one line each, about options for making that could not be met.
struct Written {
    std::string text;                    ///< the file's content
    std::vector<std::string> remarks{};  ///< for people
};

/// A kind of file.
struct WriterRow {
    std::string_view ending;         ///< file name ending, with its dot
    Content content;                 ///< where an ending may hold several things
    std::string_view description;    ///< for `--help`
    Written (*write)(const Scene&);  ///< makes the text
    /// The members of a scene that a writer reads besides surface and results.
    enum class Kind { Data, Drawing, Picture, Made } kind = Kind::Data;
    [[nodiscard]] bool is_drawing() const {
        return kind == Kind::Drawing || is_picture();
    }                                                                        ///< reads conditions, scale and
                                                                             ///< view
    [[nodiscard]] bool is_picture() const { return kind == Kind::Picture; }  ///< also reads Scene::picture
    [[nodiscard]] bool is_made() const { return kind == Kind::Made; }        ///< reads Scene::making
};

/// The unit of lengths in a file.
std::string_view unit_of(const WriterRow& writer);

/// All kinds of files. A new kind needs a source file and a row.
std::span<const WriterRow> writer_catalogue();
/// The writer for a file, by its ending. If several writers have this ending, the one with the wanted content
/// or, without one, the first. Throws InputError that lists the valid endings or contents.
const WriterRow& find_writer(const std::filesystem::path& path, std::optional<Content> content = {});
/// True if this writer is the first one with its ending, which is used if no content is given.
bool is_default(const WriterRow& writer);

}  // namespace fretwork::exports

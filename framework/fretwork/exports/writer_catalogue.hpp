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
    Centrelines,  ///< the beams as lines, with what is known of them
    Cut,          ///< the true outline, for machines that cut
    Solid,        ///< the extruded outline, for machines that print
    Facts,        ///< what a maker asks: masses, lengths, narrow places, stresses
};
/// As the command line calls it: "cut".
std::string_view content_name(Content content);
/// Throws InputError that lists what there is.
Content parse_content(const std::string& name);

/// A file's content, and what is to be said of it, one line each: options for making that could not be had.
struct Written {
    std::string text;
    std::vector<std::string> remarks{};
};

/// A kind of file.
struct WriterRow {
    std::string_view ending;  ///< with its dot
    Content content;
    std::string_view description;
    Written (*write)(const Scene&);
    /// The members of a scene that a writer reads besides surface and results.
    enum class Kind { Data, Drawing, Picture, Made } kind = Kind::Data;
    [[nodiscard]] bool is_drawing() const {
        return kind == Kind::Drawing || is_picture();
    }                                                                        ///< conditions, scale and view
    [[nodiscard]] bool is_picture() const { return kind == Kind::Picture; }  ///< Scene::picture, too
    [[nodiscard]] bool is_made() const { return kind == Kind::Made; }        ///< Scene::making
};

/// The unit of lengths in a file.
std::string_view unit_of(const WriterRow& writer);

/// All kinds of files: a new one is a file and a row.
std::span<const WriterRow> writer_catalogue();
/// The writer for a file, by its ending; of several the first, or that of the wanted content. Throws
/// InputError that lists what there is.
const WriterRow& find_writer(const std::filesystem::path& path, std::optional<Content> content = {});
/// Whether this is what its ending means where no content is named.
bool is_default(const WriterRow& writer);

}  // namespace fretwork::exports

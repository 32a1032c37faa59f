// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace fretwork::app {

/// Read a file as the stage that owns its kind reads it, and name the kind: "fretwork/project/3", "library",
/// "outline (svg)", "mesh (obj)", "deck (inp)", "image (png)". A JSON file says its kind itself, whatever its
/// ending, and a library begins as a database does. Drawings, meshes, decks and images are told apart by
/// their endings, as in every command that reads them. Throws as the reader does; InputError if the file is
/// of no kind that fretwork reads or writes as JSON.
///
/// @param layout  a painting's node layout, a name or a file; empty: the one that the painting names
std::string check_file(const std::filesystem::path& path, const std::string& layout);

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace fretwork::app {

/// Read a file as the stage that owns its kind reads it, and name the kind: "fretwork/project/3", "library",
/// "outline (svg)", "mesh (obj)", "deck (inp)", "image (png)". A library is recognized by its first bytes,
/// with any ending. Drawings, meshes, decks and images are recognized by their endings, as in every command
/// that reads them. All other JSON files name their kind. Throws as the reader does; InputError for any other
/// kind of file, a pipe or a device.
///
/// @param layout  a painting's node layout, a name or a file; empty: the built-in layout that the painting
///                names
std::string check_file(const std::filesystem::path& path, const std::string& layout);

}  // namespace fretwork::app

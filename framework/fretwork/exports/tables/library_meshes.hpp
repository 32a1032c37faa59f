// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/exports/tables/line_set.hpp>
#include <fretwork/library/library.hpp>

#include <filesystem>
#include <span>
#include <string_view>

namespace fretwork::exports {

/// The beams of a pattern in the setting's regular polygon.
LineSet pattern_lines(const pattern::NodeLayout& layout, const pattern::Pattern& pattern,
                      const reduction::Setting& setting);

/// Kinds of files for meshes of lines.
enum class MeshKind {
    Obj,  ///< Wavefront .obj
    Ply   ///< Stanford .ply
};

/// Options of export_meshes().
struct MeshOptions {
    MeshKind kind = MeshKind::Obj;                                            ///< kind of the files
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< tile models of the
                                                                              ///< calibrations
    base::Control control{};                                                  ///< progress and stop
};

/// Write each of `patterns` as an edge mesh in the polygon of the library's setting (`<id>.obj` or `.ply`).
/// Also write the geometry of the pattern's best calibration of each tile model with parameters, such as
/// `<id>.paper6.obj`. A missing folder is created. Returns the number of files. Throws as model_lines(), and
/// IoError and Stopped.
std::size_t export_meshes(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                          const std::filesystem::path& folder, const MeshOptions& options = {});
/// Add the files of export_meshes() to a batch, which the caller commits. Returns their number. Throws as
/// export_meshes().
std::size_t add_meshes(const library::Library& library, std::span<const pattern::NamedPattern> patterns,
                       const MeshOptions& options, base::FolderBatch& batch);

}  // namespace fretwork::exports

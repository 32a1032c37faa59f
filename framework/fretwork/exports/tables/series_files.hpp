// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// One of several files for one folder.
struct NamedFile {
    std::string name;  ///< beside the others
    std::string text;  ///< its content
};

/// A result's load steps as a series in time for ParaView: `stem`.pvd lists the steps, and `stem`-1.vtu,
/// `stem`-2.vtu, .. hold the fields of each step (beam_lines). The time is the load factor, or the step's
/// number if load factors do not ascend (stages). A result without load steps is a series of one step. Each
/// step is its own file, because VTK's reader of .vtu files repeats all cells at every change of time within
/// one file. Throws as beam_lines.
std::vector<NamedFile> series_files(const simulation::Surface& surface,
                                    const simulation::SurfaceResult& result, const std::string& stem,
                                    std::optional<double> strength = {},
                                    std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports

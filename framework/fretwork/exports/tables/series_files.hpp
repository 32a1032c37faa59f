// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface.hpp>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// One of several files that belong together, in one folder.
struct NamedFile {
    std::string name;
    std::string text;
};

/// A result's load steps as a series in time for ParaView: `stem`.pvd, which names them, and for each step
/// `stem`-1.vtu, `stem`-2.vtu, .. with all that the state at that step bears (beam_lines). The time is the
/// load factor; or, where these do not ascend (stages), the step's number. A result without steps is a series
/// of one. Steps are files of their own because VTK's reader of .vtu files repeats all cells at every change
/// of a time within one file. Throws as beam_lines.
std::vector<NamedFile> series_files(const simulation::Surface& surface,
                                    const simulation::SurfaceResult& result, const std::string& stem,
                                    std::optional<double> strength = {},
                                    std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A file for a folder.
struct NamedFile {
    std::string name;  ///< name of the file in the folder
    std::string text;  ///< content of the file
};

/// The name of the file of a step in a series, with `step` from 1: `stem`-1.vtu.
std::string series_step_name(const std::string& stem, std::size_t step);

/// A result's load steps as a series in time for ParaView: `stem`.pvd lists the steps, and `stem`-1.vtu,
/// `stem`-2.vtu, .. have the fields of each step (as beam_lines, without modes). The time of a step is its
/// load factor, or its number if load factors do not ascend, as in load stages. A result without load steps
/// gives one step. Each step has its own file, because VTK's reader of .vtu files repeats all cells at every
/// change of time within one file. Throws as beam_lines, and InputError if `stem` has one of the characters
/// " & < >.
std::vector<NamedFile> series_files(const simulation::Surface& surface,
                                    const simulation::SurfaceResult& result, const std::string& stem,
                                    std::optional<double> strength = {},
                                    std::span<const reduction::TileModel> models = reduction::tile_models());

}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/result_file.hpp>
#include <fretwork/simulation/conditions.hpp>
#include <fretwork/simulation/surface.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::exports {

/// What a surface can be written from: itself, a load case to draw on it, and results.
struct Scene {
    struct LabelledResult {
        std::string label;
        mechanics::Result result;
    };
    simulation::Surface surface;
    std::optional<simulation::Conditions> conditions{};
    std::vector<LabelledResult> results{};  ///< the first is the main one
    double displacement_scale = 1.0;        ///< in drawings of deformed states
};

/// A kind of file.
struct WriterRow {
    std::string_view ending;  ///< with its dot
    std::string_view description;
    std::string (*text)(const Scene&);
    bool is_drawing = false;  ///< shows Scene::conditions, and takes Scene::displacement_scale
};

/// All kinds of files: a new one is a file and a row.
std::span<const WriterRow> writer_catalogue();
/// The writer for a file, by its ending. Throws InputError that lists what there is.
const WriterRow& find_writer(const std::filesystem::path& path);

}  // namespace fretwork::exports

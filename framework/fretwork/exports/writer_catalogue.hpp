// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/surface_drawing.hpp>
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

/// A picture's size in pixels.
struct PixelSize {
    int width = 1600;
    int height = 1000;
};

/// How bars in 3D are shown.
struct PictureOptions {
    PixelSize size{};                     ///< of pictures made of pixels
    std::string colour = "displacement";  ///< one of bar_field_names() (bar_scene.hpp), or "plain"
};

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
    std::optional<ViewOptions> view{};      ///< from where these are seen; none: from where most is seen
    PictureOptions picture{};
    std::optional<double> strength{};  ///< Pa, that utilizations are told of; none: they are not
    DrawnLabels labels{};              ///< of drawings from above
};

/// A kind of file.
struct WriterRow {
    std::string_view ending;  ///< with its dot
    std::string_view description;
    std::string (*text)(const Scene&);
    /// What of a scene it looks at besides surface and results.
    enum class Kind { Data, Drawing, Picture } kind = Kind::Data;
    [[nodiscard]] bool is_drawing() const { return kind != Kind::Data; }     ///< conditions, scale and view
    [[nodiscard]] bool is_picture() const { return kind == Kind::Picture; }  ///< Scene::picture, too
};

/// All kinds of files: a new one is a file and a row.
std::span<const WriterRow> writer_catalogue();
/// The writer for a file, by its ending. Throws InputError that lists what there is.
const WriterRow& find_writer(const std::filesystem::path& path);

}  // namespace fretwork::exports

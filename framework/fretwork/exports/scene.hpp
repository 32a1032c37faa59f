// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/exports/drawings/surface_drawing.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/fabrication/sheets.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/results/surface_result.hpp>
#include <fretwork/simulation/surface.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fretwork::exports {

/// A picture's size in pixels.
struct PixelSize {
    int width = 1600;
    int height = 1000;
    [[nodiscard]] std::size_t count() const { return at(0, height); }
    /// The number of a pixel: they are counted row by row from the upper left.
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// How bars in 3D are shown.
struct PictureOptions {
    PixelSize size{};                     ///< of pictures made of pixels
    std::string colour = "displacement";  ///< one of bar_field_names() (bar_scene.hpp), or "plain"
};

/// How a surface is made.
struct Making {
    fabrication::ShapeOptions shape{};
    std::optional<fabrication::Bed> bed{};  ///< what is cut is cut into sheets of it
    fabrication::FactsOptions facts{};
};

/// Everything that a surface can be written from: the surface, a load case to draw on it, and results.
struct Scene {
    struct LabelledResult {
        std::string label;
        simulation::SurfaceResult result;
    };
    simulation::Surface surface;
    std::optional<simulation::Conditions> conditions{};
    std::vector<LabelledResult> results{};  ///< the first is the main one
    double displacement_scale = 1.0;        ///< in drawings of deformed states
    std::optional<ViewOptions> view{};      ///< from where these are seen; none: from where most is seen
    PictureOptions picture{};
    std::optional<double> strength{};  ///< Pa, the reference of utilizations; none: the material's
    DrawnLabels labels{};              ///< of drawings from above
    Making making{};                   ///< of what is cut or printed
    std::optional<simulation::LoadCase> load_case{};  ///< that of `conditions`; facts use it
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< of the results
    base::Control control{};  ///< asked by writers of large files; who stops throws Stopped
    /// Pa: the given one, or the material's; none: no utilizations.
    [[nodiscard]] std::optional<double> known_strength() const {
        return strength ? strength : surface.setting.strength;
    }
};

}  // namespace fretwork::exports

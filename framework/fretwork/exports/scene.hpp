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
    int width = 1600;   ///< pixels
    int height = 1000;  ///< pixels
    /// The number of pixels.
    [[nodiscard]] std::size_t count() const { return at(0, height); }
    /// The index of a pixel, counted row by row from the upper left.
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// Options of pictures of bars in 3D.
struct PictureOptions {
    PixelSize size{};                     ///< size of PNG pictures
    std::string colour = "displacement";  ///< one of bar_field_names() (bar_scene.hpp), or "plain"
};

/// The options for making a surface.
struct Making {
    fabrication::ShapeOptions shape{};      ///< widths, fillets, kerf
    std::optional<fabrication::Bed> bed{};  ///< the surface is cut in parts on sheets of this size
    fabrication::FactsOptions facts{};      ///< what is asked of it
};

/// The input of all writers: the surface, a load case to draw on it, and results.
struct Scene {
    /// A result with its name in legends.
    struct LabelledResult {
        std::string label;                 ///< in legends
        simulation::SurfaceResult result;  ///< of this surface
    };
    simulation::Surface surface;                         ///< what is drawn
    std::optional<simulation::Conditions> conditions{};  ///< supports and loads, if a load case is drawn
    std::vector<LabelledResult> results{};               ///< the first is the main one
    double displacement_scale = 1.0;    ///< factor on displacements in drawings of deformed states
    std::optional<ViewOptions> view{};  ///< direction of the viewer of deformed states; none: the one
                                        ///< that shows most
    PictureOptions picture{};           ///< size, view and colours
    std::optional<double> strength{};   ///< Pa, the reference of utilizations; none: the material's
    DrawnLabels labels{};               ///< numbers on drawings from above
    Making making{};                    ///< options for files to cut or print
    std::optional<simulation::LoadCase> load_case{};  ///< the load case of `conditions`; facts use it
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< tile models of the results
    base::Control control{};  ///< checked by writers of large files, which throw Stopped
    /// The given strength or else the material's, Pa. None: utilizations are not known.
    [[nodiscard]] std::optional<double> known_strength() const {
        return strength ? strength : surface.setting.strength;
    }
};

}  // namespace fretwork::exports

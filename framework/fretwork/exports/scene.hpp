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

/// The size of a picture in pixels.
struct PixelSize {
    int width = 1600;   ///< pixels
    int height = 1000;  ///< pixels
    /// The number of pixels.
    [[nodiscard]] std::size_t count() const { return at(0, height); }
    /// The index of a pixel, counted row by row from the upper left corner.
    [[nodiscard]] std::size_t at(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
    }
};

/// Options of pictures of bars in 3D.
struct PictureOptions {
    PixelSize size{};  ///< size of PNG pictures
    /// Field shown as colours, one of bar_field_names() (bar_scene.hpp), or "plain".
    std::string colour = "displacement";
    /// The shape at rest behind bent bars, in PNG pictures.
    enum class Ghost { Shown, Hidden };
    Ghost ghost = Ghost::Shown;  ///< whether the shape at rest is drawn
};

/// Options for making a surface. Writers replace `control` and `models` in them by those of the scene.
struct Making {
    fabrication::ShapeOptions shape{};  ///< widths, fillets and kerf
    /// Size of sheets for a surface in parts; none: the surface is one part.
    std::optional<fabrication::Bed> bed{};
    fabrication::FactsOptions facts{};  ///< limits for warnings
};

/// The input of all writers: the surface, a load case to draw on it, and results.
struct Scene {
    /// A result of the scene's surface.
    struct LabelledResult {
        std::string label;                 ///< name in legends
        simulation::SurfaceResult result;  ///< the result
    };
    simulation::Surface surface;  ///< the surface
    /// Supports and loads to draw; none: no load case is drawn.
    std::optional<simulation::Conditions> conditions{};
    std::vector<LabelledResult> results{};  ///< results; the first is the main result
    double displacement_scale = 1.0;        ///< factor on displacements in drawings and pictures
    /// Direction of the viewer of deformed states. None: pictures and pages choose the best direction, and
    /// drawings take the default of ViewOptions.
    std::optional<ViewOptions> view{};
    PictureOptions picture{};  ///< size and colours of pictures
    /// Strength to which utilizations refer, Pa; none: the strength in the setting.
    std::optional<double> strength{};
    DrawnLabels labels{};                             ///< numbers on drawings from above
    Making making{};                                  ///< options for files to cut or print
    std::optional<simulation::LoadCase> load_case{};  ///< load case of `conditions`, for facts
    std::span<const reduction::TileModel> models = reduction::tile_models();  ///< tile models of the results
    base::Control control{};  ///< progress and stop; writers of large files check the stop and throw Stopped
    /// The given strength or else the strength in the setting, Pa. None: utilizations are not known.
    [[nodiscard]] std::optional<double> known_strength() const {
        return strength ? strength : surface.setting.strength;
    }
};

}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/reduction/calibration/calibration_problem.hpp>
#include <fretwork/reduction/models/tile_structure.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::reduction {

/// The input from which a tile model builds a tile.
struct TileInput {
    base::Borrowed<pattern::NodeLayout> layout;  ///< node layout of the pattern
    base::Borrowed<pattern::Fan> fan;  ///< the tile's pattern around a polygon with as many sides as the tile
    base::Borrowed<Setting> setting;   ///< material, section, joints
    base::Borrowed<geometry::Polygon> polygon;  ///< polygon of the tile: convex, counterclockwise, metres
    std::span<const double> parameters;         ///< parameters of the tile model, in the order of its row
};

/// One parameter of a tile model.
struct TileParameter {
    /// The bounds within which a parameter is fitted.
    struct Bounds {
        double lower = 0.0;  ///< smallest value, SI
        double upper = 0.0;  ///< largest value, SI
    };
    /// The scale on which a search measures the distance between two values. The bounds of a logarithmic
    /// parameter lie above zero.
    enum class Scale { Linear, Logarithmic };
    std::string name;                              ///< name in libraries, such as "I2"
    std::string unit;                              ///< SI unit of the value, such as "m^4"
    Scale scale = Scale::Linear;                   ///< scale of the search
    std::function<Bounds(const Setting&)> bounds;  ///< returns the bounds in a setting
};

/// The role of a tile model: reduced models are compared with the reference, the full model.
enum class Role {
    Reference,  ///< the full model
    Reduced     ///< any other model
};

/// The sharing of built tiles in a surface. With Congruent, a tile is built in its own axes, from a polygon
/// with coordinates rounded to a grid. The origin of these axes is the centroid of the polygon, x runs along
/// the first side (from vertex 0 to vertex 1), and y points into the tile. With None, or if the rounded
/// polygon is not convex, each tile is built in the surface's axes from its exact polygon.
enum class Sharing {
    None,      ///< each tile is built by itself
    Congruent  ///< congruent tiles are built once
};

/// A tile model builds the structure of a painted tile, which meets its neighbours at its interface nodes.
/// Each built-in tile model is a row of the catalogue.
struct TileModel {
    std::string name;           ///< name in commands, files and libraries
    std::string summary;        ///< description in one line
    Role role = Role::Reduced;  ///< reference or reduced
    /// Size of the displacements for which the model is made.
    Displacements displacements = Displacements::Small;
    Sharing sharing = Sharing::None;  ///< whether congruent tiles are built once
    /// Parameters that are fitted to a pattern's responses; empty: nothing is fitted.
    std::vector<TileParameter> parameters{};
    /// A function that builds a tile; callers use build_tile(). Throws InputError, GeometryError or
    /// NumericalError if the tile cannot be built.
    std::function<std::shared_ptr<const TileStructure>(const TileInput&)> build{};
    /// An optional function that states the calibration as an optimization problem, for models with
    /// parameters. If the function is empty, or returns null for a layout and setting, the calibration uses
    /// DifferenceProblem.
    std::function<std::unique_ptr<CalibrationProblem>(const Objective&, const pattern::NodeLayout&,
                                                      const Setting&)>
        problem{};
};

/// Build a tile by a model. Throws as the model's `build`. Throws InputError if an element other than a beam
/// has a stiffness that is not finite. Throws InputError that names the motion if such an element resists a
/// rigid motion, because the tile would then act as a support.
std::shared_ptr<const TileStructure> build_tile(const TileModel& model, const TileInput& input);

/// The built-in tile models, in the order in which commands list them.
const std::vector<TileModel>& tile_models();

/// The row with this name. Throws InputError that suggests the nearest name, or lists all names.
const TileModel& find_tile_model(std::string_view name, std::span<const TileModel> models = tile_models());

/// The index of a parameter in a model's row. Throws InputError that suggests the nearest name, or lists all.
std::size_t parameter_index(const TileModel& model, std::string_view name);

}  // namespace fretwork::reduction

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
    base::Borrowed<pattern::NodeLayout> layout;  ///< of the pattern
    base::Borrowed<pattern::Fan> fan;  ///< the tile's pattern around a polygon with as many sides as the tile
    base::Borrowed<Setting> setting;   ///< material, section, joints
    base::Borrowed<geometry::Polygon> polygon;  ///< convex, counterclockwise, metres
    std::span<const double> parameters;         ///< parameters of the tile model, in the order of its row
};

/// One parameter of a tile model.
struct TileParameter {
    /// Within which a parameter is fitted.
    struct Bounds {
        double lower = 0.0;  ///< SI
        double upper = 0.0;  ///< SI
    };
    /// The scale on which a search measures the distance between two values. Logarithmic bounds lie above
    /// zero.
    enum class Scale { Linear, Logarithmic };
    std::string name;                              ///< the name in libraries: "I2"
    std::string unit;                              ///< the SI unit of the value: "m^4"
    Scale scale = Scale::Linear;                   ///< how it is searched
    std::function<Bounds(const Setting&)> bounds;  ///< the range in which a calibration searches
};

/// The role of a tile model: reduced models are compared with the reference, the full model.
enum class Role { Reference, Reduced };

/// The choice whether congruent tiles of a surface are built once. With Congruent, a tile is built in its own
/// axes from its polygon, rounded to a tolerance: the origin is its centroid, x runs along its first side
/// (from vertex 0 to vertex 1), and y points into the tile. With None, each tile is built in the surface's
/// axes from its exact polygon.
enum class Sharing { None, Congruent };

/// A tile model, which turns a painted tile into elements between its interface nodes. A row of the
/// catalogue.
struct TileModel {
    std::string name;                                    ///< the name in commands, files and libraries
    std::string summary;                                 ///< one line
    Role role = Role::Reduced;                           ///< reference or reduced
    Displacements displacements = Displacements::Small;  ///< how far its tiles may move
    Sharing sharing = Sharing::None;                     ///< what tiles share
    std::vector<TileParameter> parameters{};  ///< fitted to a pattern's responses; empty: nothing is fitted
    /// Builds a tile; call it through build_tile(). Throws InputError or GeometryError if the tile cannot be
    /// built.
    std::function<std::shared_ptr<const TileStructure>(const TileInput&)> build{};
    /// Optional: states the calibration as an optimization problem, for models of small displacements with
    /// parameters. If it is empty or returns null for a layout and setting, DifferenceProblem builds the tile
    /// at each point and takes derivatives by differences.
    std::function<std::unique_ptr<CalibrationProblem>(const Objective&, const pattern::NodeLayout&,
                                                      const Setting&)>
        problem{};
};

/// Build a tile by a model. Throws as the model's `build`. Throws InputError that names a rigid motion if the
/// tile's elements resist it, because such a tile would act as a support.
std::shared_ptr<const TileStructure> build_tile(const TileModel& model, const TileInput& input);

/// The built-in tile models, in the order in which commands list them.
const std::vector<TileModel>& tile_models();

/// The row with this name. Throws InputError that suggests the nearest name, or lists all.
const TileModel& find_tile_model(std::string_view name, std::span<const TileModel> models = tile_models());

/// The index of a parameter in a model's row. Throws InputError that lists the parameters.
std::size_t parameter_index(const TileModel& model, std::string_view name);

}  // namespace fretwork::reduction

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
    base::Borrowed<pattern::NodeLayout> layout;
    base::Borrowed<pattern::Fan> fan;  ///< the tile's pattern, around a polygon of as many sides as the tile
    base::Borrowed<Setting> setting;
    base::Borrowed<geometry::Polygon> polygon;  ///< convex, counterclockwise, metres
    std::span<const double> parameters;         ///< of the model, in the order of its row
};

/// One parameter of a tile model.
struct TileParameter {
    struct Bounds {
        double lower = 0.0;
        double upper = 0.0;
    };
    /// How a search measures distances between two values. Logarithmic bounds lie above zero.
    enum class Scale { Linear, Logarithmic };
    std::string name;  ///< as libraries store it: "I2"
    std::string unit;  ///< of the value, SI: "m^4"
    Scale scale = Scale::Linear;
    std::function<Bounds(const Setting&)> bounds;  ///< of a calibration
};

/// The reference is the full model; reduced models are compared with it.
enum class Role { Reference, Reduced };

/// Whether congruent tiles of a surface are built once. Then a tile is built in its own axes, from its
/// polygon rounded to a tolerance: the origin in its centroid, x along its first side (from vertex 0 to
/// vertex 1), y into the tile; else in the surface's axes, from the polygon as it is.
enum class Sharing { None, Congruent };

/// A tile model: how a painted tile becomes elements between its interface nodes. A row of the catalogue.
struct TileModel {
    std::string name;     ///< what commands, files and libraries call it
    std::string summary;  ///< one line
    Role role = Role::Reduced;
    Displacements displacements = Displacements::Small;
    Sharing sharing = Sharing::None;
    std::vector<TileParameter> parameters{};  ///< fitted to a pattern's responses; none: nothing is fitted
    /// Throws InputError or GeometryError if the tile cannot be built. Call it through build_tile().
    std::function<std::shared_ptr<const TileStructure>(const TileInput&)> build{};
    /// Its calibration as an optimization problem, for models of small displacements with parameters. If it
    /// is empty, or gives none for this layout and setting, the tile is built at each point and derivatives
    /// are differences (DifferenceProblem).
    std::function<std::unique_ptr<CalibrationProblem>(const Objective&, const pattern::NodeLayout&,
                                                      const Setting&)>
        problem{};
};

/// Build a tile by a model. Throws as the model's `build`; InputError that names the motion if the tile's
/// elements resist a rigid one: such a tile would be held where nothing holds it.
std::shared_ptr<const TileStructure> build_tile(const TileModel& model, const TileInput& input);

/// The built-in tile models, in the order in which they are listed.
const std::vector<TileModel>& tile_models();

/// A row by its name. Throws InputError that names the nearest, or all.
const TileModel& find_tile_model(std::string_view name, std::span<const TileModel> models = tile_models());

/// The place of a parameter among those of a model. Throws InputError that lists them.
std::size_t parameter_index(const TileModel& model, std::string_view name);

}  // namespace fretwork::reduction

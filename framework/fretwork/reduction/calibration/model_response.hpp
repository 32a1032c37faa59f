// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/borrowed.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/unit_displacements.hpp>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace fretwork::reduction {

/// A tile built by a tile model from one pattern in the setting's regular polygon, and its displacements
/// under the setting's scenarios. A ModelTile keeps references to the model, the layout and the setting.
/// Several threads may use it at once. Parameters are in SI units, in the order of the model's row.
class ModelTile {
  public:
    /// Make the tile of a pattern in the setting's polygon. Throws as geometry::regular_polygon().
    ModelTile(base::Borrowed<TileModel> model, base::Borrowed<pattern::NodeLayout> layout,
              const pattern::Pattern& pattern, base::Borrowed<Setting> setting);

    /// The tile as a structure without supports and loads. Its first nodes are the interface nodes. Throws as
    /// build_tile().
    [[nodiscard]] StructureParts parts(std::span<const double> parameters) const;
    /// The linear displacements, from the tile's stiffness at rest. Throws NumericalError that names a
    /// scenario under which the tile can move freely, and as parts(), mechanics::assemble() and
    /// mechanics::condense().
    [[nodiscard]] UnitDisplacements displacements(std::span<const double> parameters) const;
    /// The nonlinear responses of the tile, in the form of compute_responses. `control` receives no progress.
    /// Throws as parts(), mechanics::assemble() and follow_scenario().
    [[nodiscard]] std::vector<Response> responses(std::span<const double> parameters,
                                                  const base::Control& control = {}) const;

  private:
    base::Borrowed<TileModel> model_;
    base::Borrowed<pattern::NodeLayout> layout_;
    base::Borrowed<Setting> setting_;
    geometry::Polygon polygon_;
    pattern::Fan fan_;
    std::vector<Eigen::Vector3d> interface_nodes_;
};

}  // namespace fretwork::reduction

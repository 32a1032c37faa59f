// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/detail/line_bearers.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace fretwork::simulation {
namespace {

using mechanics::NodeIndex;

/// The name of an entry in errors: its load case, and its place there.
struct EntryName {
    const LoadCase& load_case;
    std::string_view list;
    const LoadCase::Origin& origin;
    std::size_t index;  ///< position of an entry that was not read

    /// Return the value of `work`. Errors name the entry, or a part of it such as "/tiles".
    template <class Work>
    auto located(const Work& work, const std::string& part = "") const {
        const std::string place =
            "/" + std::string(list) + "/" + std::to_string(origin.position.value_or(index)) + part;
        const std::string own = "load case '" + load_case.name + "'";
        if (origin.load_case.empty()) return base::located(own, place, work);
        return base::located(
            own, "", [&] { return base::located("load case '" + origin.load_case + "'", place, work); });
    }
};

EntryName support_name(const LoadCase& load_case, std::size_t entry) {
    return {load_case, "supports", load_case.supports[entry].origin, entry};
}
EntryName prescribed_name(const LoadCase& load_case, std::size_t entry) {
    return {load_case, "prescribed", load_case.prescribed[entry].origin, entry};
}
EntryName load_name(const LoadCase& load_case, std::size_t entry) {
    return {load_case, "loads", load_case.loads[entry].origin, entry};
}
/// load_case_text() writes loads per area last.
EntryName area_load_name(const LoadCase& load_case, std::size_t entry) {
    return {load_case, "loads", load_case.area_loads[entry].origin, load_case.loads.size() + entry};
}

/// The interface nodes of an entry. Complaints name the entry.
std::vector<tiling::InterfaceIndex> picked(const Selection& where, const EntryName& name,
                                           const tiling::Tessellation& tessellation) {
    return name.located([&] { return select_some_nodes(where, tessellation); });
}

/// The tiles with an area load, and the interface nodes that bear it.
class AreaBearers {
  public:
    /// Throws InputError as select_some_nodes(), if there is no tile, or if a tile's number is out of range.
    AreaBearers(const LoadCase& load_case, std::size_t entry, const tiling::Tessellation& tessellation)
        : tiles_(tessellation.tiles.size(), true), nodes_(tessellation.interface_nodes.size(), true) {
        const LoadCase::AreaLoad& load = load_case.area_loads[entry];
        const EntryName name = area_load_name(load_case, entry);
        if (const auto* where = std::get_if<Selection>(&load.where)) {
            nodes_.assign(nodes_.size(), false);
            for (const auto node : picked(*where, name, tessellation)) nodes_[node] = true;
            return;
        }
        tiles_.assign(tiles_.size(), false);
        name.located([&] { take(std::get<LoadCase::AreaLoad::Tiles>(load.where).numbers); }, "/tiles");
    }
    [[nodiscard]] bool has(std::size_t tile) const { return tiles_[tile]; }
    [[nodiscard]] bool has(tiling::InterfaceIndex node) const { return nodes_[node]; }

  private:
    void take(const std::vector<int>& numbers) {
        if (numbers.empty()) throw base::InputError("is empty, where the number of a tile is needed");
        for (const int tile : numbers) {
            if (tile < 0 || static_cast<std::size_t>(tile) >= tiles_.size())
                throw base::InputError("there is no tile " + std::to_string(tile) + "; the last one is " +
                                       std::to_string(tiles_.size() - 1));
            tiles_[tile] = true;
        }
    }

    std::vector<bool> tiles_;
    std::vector<bool> nodes_;
};

/// Complaints name the entry.
std::vector<detail::LineBearer> bearers_of(const LoadCase& load_case, std::size_t entry,
                                           const tiling::Tessellation& tessellation) {
    return load_name(load_case, entry).located([&] {
        return detail::line_bearers(load_case.loads[entry].where, tessellation);
    });
}

/// The nodes with the parts of tiles' areas that they bear, m2: one entry for each loaded tile of a node.
std::vector<std::pair<tiling::InterfaceIndex, double>> area_shares(const LoadCase& load_case,
                                                                   std::size_t entry,
                                                                   const tiling::Tessellation& tessellation) {
    const AreaBearers bearers(load_case, entry, tessellation);
    std::vector<std::pair<tiling::InterfaceIndex, double>> shares;
    for (std::size_t t = 0; t < tessellation.tiles.size(); ++t) {
        if (!bearers.has(t)) continue;
        const auto& nodes = tessellation.tiles[t].interface_nodes;
        const double area = geometry::signed_area(tiling::tile_polygon(tessellation, tiling::TileIndex(t)));
        for (const auto node : nodes) {
            if (bearers.has(node)) shares.emplace_back(node, area / static_cast<double>(nodes.size()));
        }
    }
    return shares;
}

/// A load per length or area as a whole load, with the nodes' shares of it.
template <class Parts>
EntryMarks::Load spread_load(const Parts& parts, const Eigen::Vector3d& per_extent) {
    std::map<tiling::InterfaceIndex, double> extents;
    EntryMarks::Load load;
    for (const auto& [node, extent] : parts) {
        extents[node] += extent;
        load.extent += extent;
    }
    for (const auto& [node, extent] : extents) {
        load.nodes.push_back(node);
        load.shares.push_back(extent / load.extent);
    }
    load.force = load.extent * per_extent;
    return load;
}

EntryMarks::Load picked_load(const LoadCase::Load& load, std::vector<tiling::InterfaceIndex> nodes) {
    const double share =
        load.amount == LoadCase::Amount::Total ? 1.0 / static_cast<double>(nodes.size()) : 1.0;
    std::vector<double> shares(nodes.size(), share);
    return {std::move(nodes), std::move(shares), load.force, load.moment, 0.0};
}

class Resolver {
  public:
    Resolver(const LoadCase& load_case, const Surface& surface, std::span<const double> masses)
        : load_case_(load_case), surface_(surface), masses_(masses) {}

    Conditions resolve() && {
        if (!load_case_.combines.empty())
            throw base::InputError("load case '" + load_case_.name + "'", "/combines",
                                   "names other load cases, which are looked for in a project");
        for (std::size_t i = 0; i < load_case_.supports.size(); ++i) add_support(i);
        for (std::size_t i = 0; i < load_case_.prescribed.size(); ++i) add_prescribed(i);
        for (std::size_t i = 0; i < load_case_.loads.size(); ++i) add_load(i);
        for (std::size_t i = 0; i < load_case_.area_loads.size(); ++i) add_area_load(i);
        if (!load_case_.gravity.isZero(0)) add_weights();
        return std::move(conditions_);
    }

  private:
    [[nodiscard]] std::vector<tiling::InterfaceIndex> pick(const Selection& where,
                                                           const EntryName& name) const {
        return picked(where, name, surface_.tessellation);
    }

    void add_support(std::size_t i) {
        const LoadCase::Support& support = load_case_.supports[i];
        for (const auto node : pick(support.where, support_name(load_case_, i))) {
            conditions_.supports.push_back({NodeIndex(node.value), support.fixed});
        }
    }

    void add_prescribed(std::size_t i) {
        const LoadCase::PrescribedDisplacement& entry = load_case_.prescribed[i];
        const EntryName name = prescribed_name(load_case_, i);
        const auto nodes = pick(entry.where, name);
        name.located([&] {
            for (const auto node : nodes) {
                const mechanics::PrescribedDisplacement wanted{NodeIndex(node.value), entry.dof, entry.value};
                if (is_new(wanted)) conditions_.prescribed.push_back(wanted);
            }
        });
    }

    /// Several entries may pick one node, but must prescribe the same value there.
    [[nodiscard]] bool is_new(const mechanics::PrescribedDisplacement& wanted) {
        const auto [other, is_first] =
            prescribed_values_.try_emplace({wanted.node, wanted.dof}, wanted.value);
        if (is_first || other->second == wanted.value) return is_first;
        throw base::InputError("prescribes " + base::format_number(wanted.value) + " at interface node " +
                               std::to_string(wanted.node.value) + ", where an entry before it prescribes " +
                               base::format_number(other->second));
    }

    void add_load(std::size_t i) {
        const LoadCase::Load& load = load_case_.loads[i];
        if (load.amount == LoadCase::Amount::PerLength) return add_line_load(i);
        const auto nodes = pick(load.where, load_name(load_case_, i));
        const double share =
            load.amount == LoadCase::Amount::Total ? 1.0 / static_cast<double>(nodes.size()) : 1.0;
        for (const auto node : nodes) {
            conditions_.loads.push_back({NodeIndex(node.value), share * load.force, share * load.moment});
        }
    }

    void add_line_load(std::size_t i) {
        for (const auto& [node, length] : bearers_of(load_case_, i, surface_.tessellation))
            conditions_.loads.push_back(
                {NodeIndex(node.value), length * load_case_.loads[i].force, Eigen::Vector3d::Zero()});
    }

    void add_area_load(std::size_t i) {
        for (const auto& [node, area] : area_shares(load_case_, i, surface_.tessellation))
            conditions_.loads.push_back(
                {NodeIndex(node.value), area * load_case_.area_loads[i].per_area, Eigen::Vector3d::Zero()});
    }

    void add_weights() {
        if (surface_.setting.material.density == 0.0)
            throw base::InputError("load case '" + load_case_.name + "'", "/gravity",
                                   "there is no mass for it to act on: the material of the setting has "
                                   "density 0");
        for (std::size_t t = 0; t < masses_.size(); ++t) {
            const auto& nodes = surface_.tessellation.tiles[t].interface_nodes;
            const Eigen::Vector3d share = masses_[t] / static_cast<double>(nodes.size()) * load_case_.gravity;
            for (const auto node : nodes)
                conditions_.loads.push_back({NodeIndex(node.value), share, Eigen::Vector3d::Zero()});
            conditions_.weights += nodes.size();
        }
    }

    const LoadCase& load_case_;
    const Surface& surface_;
    std::span<const double> masses_;  ///< mass of each tile, kg
    Conditions conditions_;
    std::map<std::pair<NodeIndex, mechanics::Dof>, double> prescribed_values_;
};

}  // namespace

EntryMarks entry_marks(const LoadCase& load_case, const tiling::Tessellation& tessellation) {
    EntryMarks marks;
    for (std::size_t i = 0; i < load_case.supports.size(); ++i)
        marks.supports.push_back(
            picked(load_case.supports[i].where, support_name(load_case, i), tessellation));
    for (std::size_t i = 0; i < load_case.prescribed.size(); ++i)
        marks.prescribed.push_back(
            picked(load_case.prescribed[i].where, prescribed_name(load_case, i), tessellation));
    for (std::size_t i = 0; i < load_case.loads.size(); ++i) {
        const LoadCase::Load& load = load_case.loads[i];
        auto nodes = picked(load.where, load_name(load_case, i), tessellation);
        marks.loads.push_back(load.amount == LoadCase::Amount::PerLength
                                  ? spread_load(bearers_of(load_case, i, tessellation), load.force)
                                  : picked_load(load, std::move(nodes)));
    }
    for (std::size_t i = 0; i < load_case.area_loads.size(); ++i)
        marks.loads.push_back(
            spread_load(area_shares(load_case, i, tessellation), load_case.area_loads[i].per_area));
    return marks;
}

void check_selections(const LoadCase& load_case, const tiling::Tessellation& tessellation) {
    (void)entry_marks(load_case, tessellation);
}

bool needs_masses(const LoadCase& load_case, const Surface& surface) {
    return !load_case.gravity.isZero(0) && surface.setting.material.density > 0.0;
}

Conditions resolve(const LoadCase& load_case, const Surface& surface) {
    return resolve(load_case, surface,
                   needs_masses(load_case, surface) ? tile_masses(surface) : std::vector<double>{});
}

Conditions resolve(const LoadCase& load_case, const Surface& surface, std::span<const double> tile_masses) {
    return Resolver(load_case, surface, tile_masses).resolve();
}

mechanics::NodeValues load_rows(const Conditions& conditions, std::size_t nodes) {
    mechanics::NodeValues rows =
        mechanics::NodeValues::Zero(static_cast<Eigen::Index>(nodes), mechanics::kDofsPerNode);
    for (const mechanics::NodalLoad& load : conditions.loads) {
        rows.row(load.node).head<3>() += load.force;
        rows.row(load.node).tail<3>() += load.moment;
    }
    return rows;
}

void apply(const Conditions& conditions, mechanics::Assembly& assembly) {
    assembly.supports.insert(assembly.supports.end(), conditions.supports.begin(), conditions.supports.end());
    assembly.prescribed = conditions.prescribed;
    assembly.loads = load_rows(conditions, assembly.nodes.size());
    assembly.has_moments = std::ranges::any_of(
        conditions.loads, [](const mechanics::NodalLoad& load) { return !load.moment.isZero(0.0); });
}

}  // namespace fretwork::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/reduction/detail/condensed_hexagon.hpp>
#include <fretwork/reduction/detail/free_factor.hpp>
#include <fretwork/reduction/ring/ring_hexagon.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fretwork::reduction {
namespace {

using detail::BlockCirculant;
using detail::CondensedHexagon;
using detail::FreeFactor;
using detail::HexagonBlocks;
using detail::kPlaneParameters;
using detail::kSectors;
using detail::NodeColumns;
using detail::Plane;
using detail::PlaneParameters;
using detail::PlaneStiffness;
using detail::PlaneVector;

constexpr int kPlaneDofs = 3 * kSectors;

/// The components of a node in one plane, in the order of the blocks.
std::array<int, 3> plane_components(Plane plane) {
    return plane == Plane::InPlane ? std::array{0, 1, 5} : std::array{2, 3, 4};
}
/// The indices, among the ten parts, of a plane's parameters.
std::array<int, kPlaneParameters> plane_parts(Plane plane) {
    return plane == Plane::InPlane ? std::array{0, 2, 4, 6, 8, 9} : std::array{3, 1, 7, 5, 8, 9};
}

/// Scenarios of one plane that support the same dofs share a factorization.
struct SupportGroup {
    std::vector<Eigen::Index> free_dofs;
    struct Case {
        std::size_t scenario;
        PlaneVector load;  ///< load at a magnitude of 1 N
    };
    std::vector<Case> cases;
};

PlaneVector plane_load(const Scenario& scenario, Plane plane) {
    PlaneVector result = PlaneVector::Zero();
    for (const Scenario::Load& load : scenario.loads) {
        const std::array<double, 6> values = {load.force[0],  load.force[1],  load.force[2],
                                              load.moment[0], load.moment[1], load.moment[2]};
        const auto components = plane_components(plane);
        for (int c = 0; c < 3; ++c) result[3 * load.interface_node + c] += values[components[c]];
    }
    return result;
}

std::vector<Eigen::Index> free_dofs(const Scenario& scenario, Plane plane) {
    std::array<bool, kPlaneDofs> held{};
    for (const Scenario::Support& support : scenario.supports) {
        const auto components = plane_components(plane);
        for (int c = 0; c < 3; ++c) {
            bool& is_held = held[3 * support.interface_node + c];
            is_held = is_held || support.fixed.contains[components[c]];
        }
    }
    std::vector<Eigen::Index> result;
    for (Eigen::Index dof = 0; dof < kPlaneDofs; ++dof) {
        if (!held[dof]) result.push_back(dof);
    }
    return result;
}

std::vector<SupportGroup> support_groups(const std::vector<Scenario>& scenarios, Plane plane) {
    std::vector<SupportGroup> groups;
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
        const PlaneVector load = plane_load(scenarios[s], plane);
        if (load.isZero(0.0)) continue;
        auto free = free_dofs(scenarios[s], plane);
        auto group = std::ranges::find(groups, free, &SupportGroup::free_dofs);
        if (group == groups.end()) group = groups.insert(group, SupportGroup{std::move(free), {}});
        group->cases.push_back({s, load});
    }
    return groups;
}

}  // namespace

class RingHexagon::Impl {
  public:
    explicit Impl(const Setting& setting)
        : material_(setting.material),
          apothem_(setting.tile_side * std::numbers::sqrt3 / 2.0),
          scenario_count_(setting.scenarios.size()),
          groups_{support_groups(setting.scenarios, Plane::InPlane),
                  support_groups(setting.scenarios, Plane::OutOfPlane)} {
        for (const Plane plane : kPlanes) {
            for (int i = 0; i < kSectors; ++i) {
                turns_[index(plane)][i] = detail::turn_to(plane, std::numbers::pi * (1.5 + i / 3.0));
            }
        }
    }

    [[nodiscard]] UnitDisplacements displacements(const RingParts& parts) const {
        UnitDisplacements result(scenario_count_, mechanics::NodeValues::Zero(kSectors, 6));
        for (const Plane plane : kPlanes) {
            const CondensedHexagon hexagon(
                detail::hexagon_blocks(plane, plane_parameters(plane, parts), apothem_));
            const PlaneStiffness stiffness = global_stiffness(plane, hexagon);
            for (const SupportGroup& group : groups_[index(plane)]) {
                const FreeFactor factor(stiffness, group.free_dofs);
                for (const auto& load_case : group.cases) {
                    write(factor.solve(load_case.load), plane, result[load_case.scenario]);
                }
            }
        }
        return result;
    }

    [[nodiscard]] UnitDisplacementsAndDerivatives derivatives(const RingParts& parts,
                                                              const RingDirections& directions) const {
        UnitDisplacementsAndDerivatives result{
            UnitDisplacements(scenario_count_, mechanics::NodeValues::Zero(kSectors, 6)),
            std::vector<Eigen::MatrixXd>(scenario_count_,
                                         Eigen::MatrixXd::Zero(6 * kSectors, directions.cols()))};
        for (const Plane plane : kPlanes) {
            const PlaneParameters own = plane_parameters(plane, parts);
            const CondensedHexagon hexagon(detail::hexagon_blocks(plane, own, apothem_));
            const auto changes = block_changes(plane, own, directions);
            const PlaneStiffness stiffness = global_stiffness(plane, hexagon);
            for (const SupportGroup& group : groups_[index(plane)]) {
                const FreeFactor factor(stiffness, group.free_dofs);
                for (const auto& load_case : group.cases) {
                    const PlaneVector solution = factor.solve(load_case.load);
                    write(solution, plane, result.displacements[load_case.scenario]);
                    differentiate({plane, hexagon, changes, factor}, solution,
                                  result.derivatives[load_case.scenario]);
                }
            }
        }
        return result;
    }

    [[nodiscard]] RingParts gradient(const RingParts& parts, const SlopesOf& slopes_of) const {
        UnitDisplacements displacements(scenario_count_, mechanics::NodeValues::Zero(kSectors, 6));
        const std::array planes = {solve_plane(Plane::InPlane, parts, displacements),
                                   solve_plane(Plane::OutOfPlane, parts, displacements)};
        const UnitDisplacements slopes = slopes_of(displacements);
        RingParts result = RingParts::Zero();
        for (const Plane plane : kPlanes) add_gradient(plane, planes[index(plane)], slopes, result);
        return result;
    }

    /// Check that a scenario holds the tile. Throws InputError if the tile can move freely.
    void check_holds(const Scenario& scenario, const RingParts& parts) const {
        for (const Plane plane : kPlanes) {
            const CondensedHexagon hexagon(
                detail::hexagon_blocks(plane, plane_parameters(plane, parts), apothem_));
            const SupportGroup group{free_dofs(scenario, plane), {}};
            const PlaneVector units = units_of(plane);
            const PlaneStiffness stiffness =
                units.asDiagonal() * global_stiffness(plane, hexagon) * units.asDiagonal();
            const Eigen::MatrixXd free = stiffness(group.free_dofs, group.free_dofs);
            if (group.free_dofs.empty() || free.ldlt().rcond() > kSmallestConditioning) continue;
            throw base::InputError("scenario '" + scenario.name + "' lets the tile move freely " +
                                   (plane == Plane::InPlane ? "in its plane" : "out of its plane"));
        }
    }

  private:
    static constexpr std::array kPlanes = {Plane::InPlane, Plane::OutOfPlane};
    static constexpr double kSmallestConditioning = 1e-13;

    /// The units in which the conditioning of a stiffness does not depend on the size of the tile: 1 m for
    /// translations, and 1 m over the apothem for rotations.
    [[nodiscard]] PlaneVector units_of(Plane plane) const {
        const std::array<int, 3> components = plane_components(plane);
        PlaneVector result = PlaneVector::Ones();
        for (Eigen::Index dof = 0; dof < kPlaneDofs; ++dof) {
            if (components[dof % 3] >= 3) result[dof] = 1.0 / apothem_;
        }
        return result;
    }
    static std::size_t index(Plane plane) { return static_cast<std::size_t>(plane); }

    /// The change of a plane's blocks along a direction.
    struct Change {
        Eigen::Index direction;
        HexagonBlocks blocks;
    };
    /// One plane at given parameters.
    struct PlaneState {
        Plane plane;
        const CondensedHexagon& hexagon;
        const std::vector<Change>& changes;
        const FreeFactor& factor;
    };

    /// One plane with the solutions of all its load cases.
    struct SolvedPlane {
        PlaneParameters parameters;
        CondensedHexagon hexagon;
        struct Group {
            FreeFactor factor;
            std::vector<PlaneVector> solutions;  ///< one for each load case
        };
        std::vector<Group> groups;
    };

    SolvedPlane solve_plane(Plane plane, const RingParts& parts, UnitDisplacements& displacements) const {
        const PlaneParameters own = plane_parameters(plane, parts);
        SolvedPlane solved{own, CondensedHexagon(detail::hexagon_blocks(plane, own, apothem_)), {}};
        const PlaneStiffness stiffness = global_stiffness(plane, solved.hexagon);
        for (const SupportGroup& group : groups_[index(plane)]) {
            auto& [factor, solutions] = solved.groups.emplace_back(FreeFactor(stiffness, group.free_dofs),
                                                                   std::vector<PlaneVector>{});
            for (const auto& load_case : group.cases) {
                solutions.push_back(factor.solve(load_case.load));
                write(solutions.back(), plane, displacements[load_case.scenario]);
            }
        }
        return solved;
    }

    /// Add a plane's part of the gradient. With K u = f and K a = slope, the derivative with respect to a
    /// parameter is -a^T dK u.
    void add_gradient(Plane plane, const SolvedPlane& solved, const UnitDisplacements& slopes,
                      RingParts& gradient) const {
        HexagonBlocks work = detail::no_blocks();
        const auto& groups = groups_[index(plane)];
        for (std::size_t g = 0; g < groups.size(); ++g) {
            for (std::size_t c = 0; c < groups[g].cases.size(); ++c) {
                const PlaneVector slope = read(slopes[groups[g].cases[c].scenario], plane);
                const PlaneVector adjoint = solved.groups[g].factor.solve(slope);
                solved.hexagon.add_work(in_own_axes(plane, adjoint),
                                        in_own_axes(plane, solved.groups[g].solutions[c]), work);
            }
        }
        const auto by_parameter = detail::hexagon_block_derivatives(plane, solved.parameters, apothem_);
        const PlaneParameters rates = parameter_rates(plane);
        const auto places = plane_parts(plane);
        for (int p = 0; p < kPlaneParameters; ++p)
            gradient[places[p]] -= rates[p] * detail::sum_of_products(by_parameter[p], work);
    }

    [[nodiscard]] NodeColumns in_own_axes(Plane plane, const PlaneVector& global) const {
        const auto& turns = turns_[index(plane)];
        NodeColumns own;
        for (int i = 0; i < kSectors; ++i) own.col(i) = turns[i] * global.segment<3>(3 * i);
        return own;
    }

    [[nodiscard]] PlaneParameters plane_parameters(Plane plane, const RingParts& parts) const {
        const PlaneParameters rates = parameter_rates(plane);
        const auto places = plane_parts(plane);
        PlaneParameters result;
        for (int p = 0; p < kPlaneParameters; ++p) result[p] = rates[p] * parts[places[p]];
        return result;
    }

    /// The derivatives of a plane's parameters with respect to the parts from which they are computed.
    [[nodiscard]] PlaneParameters parameter_rates(Plane plane) const {
        const double E = material_.young_modulus;
        const double along = plane == Plane::InPlane ? E : material_.shear_modulus();
        return {along, E, along, E, 1.0, 1.0};
    }

    /// The changes of the blocks along all directions that affect the plane; other directions are left out.
    [[nodiscard]] std::vector<Change> block_changes(Plane plane, const PlaneParameters& parameters,
                                                    const RingDirections& directions) const {
        const auto by_parameter = detail::hexagon_block_derivatives(plane, parameters, apothem_);
        const PlaneParameters rates = parameter_rates(plane);
        const auto places = plane_parts(plane);
        std::vector<Change> changes;
        for (Eigen::Index k = 0; k < directions.cols(); ++k) {
            HexagonBlocks sum = detail::no_blocks();
            bool matters = false;
            for (int p = 0; p < kPlaneParameters; ++p) {
                const double rate = rates[p] * directions(places[p], k);
                if (rate == 0.0) continue;
                detail::add_blocks(sum, rate, by_parameter[p]);
                matters = true;
            }
            if (matters) changes.push_back({k, sum});
        }
        return changes;
    }

    [[nodiscard]] PlaneStiffness global_stiffness(Plane plane, const CondensedHexagon& hexagon) const {
        const BlockCirculant own = hexagon.stiffness();
        const auto& turns = turns_[index(plane)];
        PlaneStiffness stiffness;
        for (int i = 0; i < kSectors; ++i) {
            const Eigen::Matrix3d turned_back = turns[i].transpose();
            for (int j = i; j < kSectors; ++j) {
                const Eigen::Matrix3d half = turned_back * own.blocks[j - i];
                const Eigen::Matrix3d turned = half * turns[j];
                stiffness.block<3, 3>(3 * i, 3 * j) = turned;
                stiffness.block<3, 3>(3 * j, 3 * i) = turned.transpose();
            }
        }
        return stiffness;
    }

    static void write(const PlaneVector& solution, Plane plane, mechanics::NodeValues& displacements) {
        const auto components = plane_components(plane);
        for (int node = 0; node < kSectors; ++node) {
            for (int c = 0; c < 3; ++c) displacements(node, components[c]) = solution[3 * node + c];
        }
    }

    static PlaneVector read(const mechanics::NodeValues& displacements, Plane plane) {
        const auto components = plane_components(plane);
        PlaneVector result;
        for (int node = 0; node < kSectors; ++node) {
            for (int c = 0; c < 3; ++c) result[3 * node + c] = displacements(node, components[c]);
        }
        return result;
    }

    void differentiate(const PlaneState& state, const PlaneVector& solution,
                       Eigen::MatrixXd& derivatives) const {
        const auto& turns = turns_[index(state.plane)];
        const NodeColumns interface = in_own_axes(state.plane, solution);
        const NodeColumns ring = state.hexagon.ring_displacements(interface);
        const auto components = plane_components(state.plane);
        for (const Change& by : state.changes) {
            const NodeColumns forces = state.hexagon.changed_forces(by.blocks, interface, ring);
            PlaneVector load;
            for (int i = 0; i < kSectors; ++i) {
                load.segment<3>(3 * i) = -(turns[i].transpose() * forces.col(i));
            }
            const PlaneVector change = state.factor.solve(load);
            for (int node = 0; node < kSectors; ++node) {
                for (int c = 0; c < 3; ++c)
                    derivatives(6 * node + components[c], by.direction) = change[3 * node + c];
            }
        }
    }

    mechanics::Material material_;
    double apothem_;
    std::size_t scenario_count_;
    std::array<std::vector<SupportGroup>, 2> groups_;
    std::array<std::array<Eigen::Matrix3d, kSectors>, 2> turns_;
};

bool RingHexagon::fits(const pattern::NodeLayout& layout, const Setting& setting) {
    return layout.interface_nodes().size() == 1 && setting.sides == kSectors;
}

RingHexagon::RingHexagon(const Setting& setting) {
    setting.validate();
    if (setting.sides != kSectors) {
        throw base::InputError("a ring with links is calibrated in a hexagon; the setting's polygon has " +
                               std::to_string(setting.sides) + " sides");
    }
    impl_ = std::make_unique<Impl>(setting);
    RingParts usual = ring_units(setting);
    usual[kRingTheta] = 0.0;
    usual[kRingR] = setting.tile_side / 2.0;
    for (const Scenario& scenario : setting.scenarios) impl_->check_holds(scenario, usual);
}
RingHexagon::RingHexagon(RingHexagon&&) noexcept = default;
RingHexagon& RingHexagon::operator=(RingHexagon&&) noexcept = default;
RingHexagon::~RingHexagon() = default;

UnitDisplacements RingHexagon::displacements(const RingParts& parts) const {
    return impl_->displacements(parts);
}

UnitDisplacementsAndDerivatives RingHexagon::derivatives(const RingParts& parts,
                                                         const RingDirections& directions) const {
    return impl_->derivatives(parts, directions);
}

RingParts RingHexagon::gradient(const RingParts& parts, const SlopesOf& slopes_of) const {
    return impl_->gradient(parts, slopes_of);
}

}  // namespace fretwork::reduction

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/goals/case_goals.hpp>
#include <fretwork/geometry/box.hpp>
#include <fretwork/simulation/load_cases/selection.hpp>
#include <fretwork/tiling/painting/field.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fretwork::design::detail {
namespace {

using mechanics::NodeValues;
using tiling::InterfaceIndex;
using tiling::Tessellation;

/// Up to this distance, m, a node lies on the mesh. The mesh's normal then replaces the direction from the
/// mesh to the node.
constexpr double kOnSurface = 1e-9;
/// A wanted displacement above this multiple of the surface's size is an error of units.
constexpr double kFarthest = 10.0;

Eigen::Vector3d place_of(const Tessellation& tessellation, InterfaceIndex node) {
    const geometry::Point2& point = tessellation.interface_nodes[node];
    return {point.x, point.y, 0.0};
}

double size_of(const FreeVector& vector) {
    double square = 0.0;
    for (const auto& component : vector) square += component.value_or(0.0) * component.value_or(0.0);
    return std::sqrt(square);
}

/// The displacements of nodes by expressions of their places.
std::vector<FreeVector> formula_values(const FormulaGoal& goal, const std::vector<InterfaceIndex>& nodes,
                                       const Tessellation& tessellation) {
    std::vector<geometry::Point2> points;
    for (const InterfaceIndex node : nodes) points.push_back(tessellation.interface_nodes[node]);
    const geometry::Box box = tiling::bounding_box(tessellation);
    std::vector<FreeVector> values(nodes.size());
    for (std::size_t c = 0; c < 3; ++c) {
        if (!goal.displacement[c]) continue;
        const std::vector<double> component = tiling::expression_values(*goal.displacement[c], box, points);
        for (std::size_t i = 0; i < nodes.size(); ++i) values[i][c] = component[i];
    }
    return values;
}

std::vector<InterfaceIndex> named_nodes(const NodesGoal& goal, const Tessellation& tessellation) {
    std::vector<InterfaceIndex> nodes;
    for (const int node : goal.nodes) {
        if (!tessellation.interface_nodes.has(InterfaceIndex(node)))
            throw base::InputError("there is no interface node " + std::to_string(node) +
                                   "; they run from 0 to " +
                                   std::to_string(tessellation.interface_nodes.size() - 1));
        nodes.emplace_back(node);
    }
    return nodes;
}

}  // namespace

CaseGoals::CaseGoals(const Target& target, const std::string& load_case, const std::string& default_case,
                     const Tessellation& tessellation)
    : length_(tiling::mean_tile_side(tessellation)) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < target.goals.size(); ++i) {
        const Goal& goal = target.goals[i];
        if ((goal.load_case.empty() ? default_case : goal.load_case) != load_case) continue;
        base::located("", "/goals/" + std::to_string(i), [&] {
            goal.validate();
            add(goal, tessellation);
        });
        for (; first < goals_.size(); ++first) goals_[first].goal = i;
    }
    require_agreement();
}

void CaseGoals::add(const Goal& goal, const Tessellation& tessellation) {
    const double size = tiling::bounding_box(tessellation).diagonal();
    const double before = std::exchange(largest_, 0.0);
    add_nodes(goal, tessellation);
    if (!(largest_ <= kFarthest * size))
        throw base::InputError("asks for a displacement of " + plain_text(WarnedValue{largest_}) +
                               ", where the surface is " + plain_text(WarnedValue{size}) +
                               " across: target files have metres, and " + base::format_number(kFarthest) +
                               " times its size is the most");
    largest_ = std::max(largest_, before);
}

void CaseGoals::add_nodes(const Goal& goal, const Tessellation& tessellation) {
    const auto add_each = [&](const std::vector<InterfaceIndex>& nodes, const auto& what_of) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            goals_.push_back({nodes[i].value, place_of(tessellation, nodes[i]), what_of(i), goal.weight});
    };
    if (const auto* own = std::get_if<NodesGoal>(&goal.what)) {
        const auto nodes = named_nodes(*own, tessellation);
        add_each(nodes, [&](std::size_t i) {
            FreeVector wanted = own->values[i];
            if (own->quantity == NodesGoal::Quantity::Positions) {
                const Eigen::Vector3d place = place_of(tessellation, nodes[i]);
                for (int c = 0; c < 3; ++c) {
                    auto& component = wanted[static_cast<std::size_t>(c)];
                    if (component) *component -= place[c];
                }
            }
            largest_ = std::max(largest_, size_of(wanted));
            return Components{wanted};
        });
    } else if (const auto* formula = std::get_if<FormulaGoal>(&goal.what)) {
        const auto nodes = simulation::select_nodes(formula->where, tessellation);
        const auto values = formula_values(*formula, nodes, tessellation);
        for (const FreeVector& value : values) largest_ = std::max(largest_, size_of(value));
        add_each(nodes, [&](std::size_t i) { return Components{values[i]}; });
    } else if (const auto* turned = std::get_if<RotationGoal>(&goal.what)) {
        largest_ = std::max(largest_, length_ * size_of(turned->rotation));
        add_each(simulation::select_nodes(turned->where, tessellation), [&](std::size_t) {
            return Components{turned->rotation, true};
        });
    } else {
        const auto& own_mesh = std::get<MeshGoal>(goal.what);
        auto mesh = std::make_shared<const SpaceMesh>(own_mesh.mesh);
        const auto nodes = simulation::select_nodes(own_mesh.where, tessellation);
        for (const InterfaceIndex node : nodes) {
            const Eigen::Vector3d place = place_of(tessellation, node);
            largest_ = std::max(largest_, (mesh->nearest(place).point - place).norm());
        }
        add_each(nodes, [&](std::size_t) { return mesh; });
    }
}

bool CaseGoals::slides() const {
    return std::ranges::any_of(goals_, [](const NodeGoal& wish) { return wish.what.index() == 1; });
}

void CaseGoals::observe(const NodeGoal& wish, const NodeValues& displacements, const Eigen::Vector3d& aim,
                        std::vector<Observation>& list) const {
    const auto row = displacements.row(wish.node);
    if (const auto* components = std::get_if<Components>(&wish.what)) {
        const Eigen::Index first = components->is_rotation ? 3 : 0;
        for (Eigen::Index c = 0; c < 3; ++c) {
            const auto& wanted = components->wanted[static_cast<std::size_t>(c)];
            if (!wanted) continue;
            Observation own{.node = wish.node, .weight = wish.weight};
            const double unit = components->is_rotation ? length_ : 1.0;
            own.direction[first + c] = unit;
            own.residual = unit * (row[first + c] - *wanted) - (components->is_rotation ? 0.0 : aim[c]);
            list.push_back(own);
        }
        return;
    }
    const Eigen::Vector3d point = wish.place + row.head<3>().transpose() - aim;
    const auto nearest = std::get<1>(wish.what)->nearest(point);
    const Eigen::Vector3d off = point - nearest.point;
    const double distance = off.norm();
    Observation own{.node = wish.node, .residual = distance, .weight = wish.weight};
    own.direction.head<3>() = distance > kOnSurface ? Eigen::Vector3d(off / distance) : nearest.normal;
    list.push_back(own);
}

std::vector<Observation> CaseGoals::observe(const NodeValues& displacements, const NodeValues& aim) const {
    std::vector<Observation> list;
    for (const NodeGoal& wish : goals_) {
        const Eigen::Vector3d own_aim = aim.rows() == 0
                                            ? Eigen::Vector3d::Zero()
                                            : Eigen::Vector3d(aim.row(wish.node).head<3>().transpose());
        observe(wish, displacements, own_aim, list);
    }
    return list;
}

std::vector<double> CaseGoals::distances(const NodeValues& displacements) const {
    std::vector<double> result;
    std::vector<Observation> own;
    for (const NodeGoal& wish : goals_) {
        own.clear();
        observe(wish, displacements, Eigen::Vector3d::Zero(), own);
        double square = 0.0;
        for (const Observation& observation : own) square += observation.residual * observation.residual;
        result.push_back(std::sqrt(square));
    }
    return result;
}

}  // namespace fretwork::design::detail

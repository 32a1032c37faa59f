// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of goals against each other and against held components; comparison with a surface's displacements.
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/design/goals/case_goals.hpp>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace fretwork::design::detail {
namespace {

using mechanics::NodeValues;

/// Differences below this share of the largest displacement wanted are rounding.
constexpr double kSameGoal = 1e-6;
/// A goal contradicts a held value if they differ by more than this share of the largest displacement wanted.
constexpr double kFarFromHeld = 0.01;

std::string component_name(std::size_t component) {
    return std::string(mechanics::kDofNames[component]);
}

WarnedValue warned_value(std::size_t component, double value) {
    return {value, component < 3 ? WarnedValue::Quantity::Length : WarnedValue::Quantity::Angle};
}

std::string value_text(std::size_t component, double value) {
    return component_name(component) + " = " + plain_text(warned_value(component, value));
}

/// The values at which components are held, by node and component.
std::map<std::pair<Eigen::Index, std::size_t>, double> held_values(const simulation::Conditions& held) {
    std::map<std::pair<Eigen::Index, std::size_t>, double> values;
    for (const mechanics::Support& support : held.supports) {
        for (std::size_t d = 0; d < 6; ++d) {
            if (support.fixed.contains[d]) values[{support.node.value, d}] = 0.0;
        }
    }
    for (const mechanics::PrescribedDisplacement& own : held.prescribed)
        values[{own.node.value, static_cast<std::size_t>(own.dof)}] = own.value;
    return values;
}

}  // namespace

void CaseGoals::require_agreement() const {
    struct Wanted {
        double value = 0.0;
        std::size_t goal = 0;
    };
    std::map<std::pair<Eigen::Index, std::size_t>, Wanted> known;
    for (const NodeGoal& wish : goals_) {
        const auto* components = std::get_if<Components>(&wish.what);
        if (components == nullptr) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            if (!components->wanted[c]) continue;
            const std::size_t component = c + (components->is_rotation ? 3 : 0);
            const double value = *components->wanted[c];
            const auto [entry, is_new] = known.try_emplace({wish.node, component}, Wanted{value, wish.goal});
            const double unit = components->is_rotation ? length_ : 1.0;
            if (is_new || unit * std::abs(entry->second.value - value) <= kSameGoal * largest_) continue;
            throw base::InputError(
                "", "/goals/" + std::to_string(wish.goal),
                "wants " + value_text(component, value) + " of node " + std::to_string(wish.node) +
                    ", of which /goals/" + std::to_string(entry->second.goal) + " wants " +
                    value_text(component, entry->second.value) + ": a component of a node has one goal");
        }
    }
}

std::vector<DesignWarning> CaseGoals::against(const simulation::Conditions& held) const {
    struct Conflict {
        std::set<Eigen::Index> nodes;
        DesignWarning first;
    };
    std::map<std::size_t, Conflict> conflicts;
    const auto values = held_values(held);
    for (const NodeGoal& wish : goals_) {
        const auto* components = std::get_if<Components>(&wish.what);
        if (components == nullptr) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t component = c + (components->is_rotation ? 3 : 0);
            const auto own = values.find({wish.node, component});
            if (!components->wanted[c] || own == values.end()) continue;
            const double unit = components->is_rotation ? length_ : 1.0;
            if (unit * std::abs(*components->wanted[c] - own->second) <= kFarFromHeld * largest_) continue;
            Conflict& conflict = conflicts[wish.goal];
            conflict.nodes.insert(wish.node);
            if (!conflict.first.text.empty()) continue;
            const std::string name = component_name(component);
            conflict.first.text = "wants " + name + " = {0} of node " + std::to_string(wish.node) +
                                  ", which is held at " + name + " = {1}";
            conflict.first.values = {warned_value(component, *components->wanted[c]),
                                     warned_value(component, own->second)};
        }
    }
    std::vector<DesignWarning> warnings;
    for (auto& [goal, conflict] : conflicts) {
        DesignWarning& own = conflict.first;
        own.text = "/goals/" + std::to_string(goal) + " " + own.text;
        if (conflict.nodes.size() > 1)
            own.text += "; " + std::to_string(conflict.nodes.size()) + " of its nodes are held elsewhere";
        warnings.push_back(std::move(own));
    }
    return warnings;
}

std::vector<CaseGoals::Place> CaseGoals::places(const NodeValues& displacements) const {
    std::vector<Place> result;
    std::vector<Observation> own;
    for (const NodeGoal& wish : goals_) {
        own.clear();
        observe(wish, displacements, Eigen::Vector3d::Zero(), own);
        Place place{.node = wish.node,
                    .wanted = wish.place + displacements.row(wish.node).head<3>().transpose()};
        double square = 0.0;
        for (const Observation& each : own) {
            place.wanted -= each.residual * each.direction.head<3>();
            square += each.residual * each.residual;
        }
        place.distance = std::sqrt(square);
        result.push_back(place);
    }
    return result;
}

CaseGoals::Products CaseGoals::products(const NodeValues& displacements) const {
    const std::vector<Observation> there = observe(displacements, {});
    const std::vector<Observation> rest =
        observe(NodeValues::Zero(displacements.rows(), displacements.cols()), {});
    Products sums;
    for (std::size_t i = 0; i < there.size(); ++i) {
        const double wanted = -rest[i].residual;
        const double reached = there[i].residual - rest[i].residual;
        sums.wanted += there[i].weight * wanted * wanted;
        sums.both += there[i].weight * wanted * reached;
        sums.there += there[i].weight * reached * reached;
    }
    return sums;
}

}  // namespace fretwork::design::detail

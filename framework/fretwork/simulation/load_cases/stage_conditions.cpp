// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>
#include <fretwork/simulation/load_cases/stage_conditions.hpp>

#include <algorithm>

namespace fretwork::simulation {
namespace {

std::string component_text(int node, int dof) {
    return std::string(mechanics::kDofNames[static_cast<std::size_t>(dof)]) + " of node " +
           std::to_string(node);
}

/// An entry of most lists is one of the file's list.
template <class Entry>
std::size_t place_in_file(const std::vector<Entry>&, std::size_t entry) {
    return entry;
}
/// An entry of the file may prescribe several components.
std::size_t place_in_file(const std::vector<LoadCase::PrescribedDisplacement>& list, std::size_t entry) {
    return list[entry].origin.position.value_or(entry);
}

/// Calls `take(entry)` for each entry of a list of a load stage; errors name the load stage and the entry.
template <class Entry, class Take>
void for_entries(const LoadStage& stage, const std::string& list, const std::vector<Entry>& entries,
                 const Take& take) {
    for (std::size_t i = 0; i < entries.size(); ++i)
        base::located("load stage '" + stage.name + "'",
                      "/" + list + "/" + std::to_string(place_in_file(entries, i)),
                      [&] { take(entries[i]); });
}

/// As parse_stages() does: what it would refuse in the file of a result is refused before the work.
void check_entries(const LoadStage& stage) {
    if (stage.is_empty())
        throw base::InputError("load stage '" + stage.name + "'", "",
                               "changes nothing: it needs one of loads, prescribed, keep, free");
}

void check_names(std::span<const LoadStage> stages) {
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const auto same = std::ranges::find(stages.first(i), stages[i].name, &LoadStage::name);
        if (same == stages.first(i).end()) continue;
        throw base::InputError("load stage '" + stages[i].name + "'", "",
                               "is there twice, in positions " + std::to_string(same - stages.begin() + 1) +
                                   " and " + std::to_string(i + 1) + "; each stage needs a name of its own");
    }
}

}  // namespace

StageConditions::StageConditions(const Surface& surface, const StagePlan& plan)
    : surface_(surface), plan_(plan) {
    LoadCase supports;
    supports.name = plan.supports->name;
    supports.supports = plan.supports->supports;
    supports_ = resolve(supports, surface).supports;
    for (const mechanics::Support& support : supports_)
        for (int d = 0; d < mechanics::kDofsPerNode; ++d)
            if (support.fixed.contains[d]) supported_.emplace(support.node.value, d);
}

mechanics::StageTarget StageConditions::advance(const LoadStage& stage,
                                                const mechanics::NodeValues& displacements,
                                                std::size_t nodes) {
    claims_.clear();
    take_load_cases(stage);
    for_entries(stage, "free", stage.free, [&](const auto& entry) { release(entry); });
    for_entries(stage, "keep", stage.keep, [&](const auto& entry) { keep(entry, displacements); });
    for_entries(stage, "prescribed", stage.prescribed, [&](const auto& entry) { prescribe(entry); });
    mechanics::StageTarget target{supports_, {}, loads(nodes)};
    for (const auto& [place, value] : held_)
        target.prescribed.push_back(
            {mechanics::NodeIndex(place.first), static_cast<mechanics::Dof>(place.second), value});
    return target;
}

/// The load stage itself may release, keep or prescribe components of load cases, so they are not claimed.
void StageConditions::take_load_cases(const LoadStage& stage) {
    std::set<std::string> named;
    std::map<Place, double> values;
    for_entries(stage, "loads", stage.loads, [&](const LoadCase::Share& share) {
        if (!named.insert(share.load_case).second)
            throw base::InputError("names the load case '" + share.load_case + "' a second time");
        factors_[share.load_case] = share.factor;
        LoadCase moved;
        moved.name = share.load_case;
        moved.prescribed = stage_load_case(plan_, share.load_case).prescribed;
        for (const auto& given : resolve(moved, surface_).prescribed) {
            const double value = share.factor * given.value;
            const Place place{given.node.value, static_cast<int>(given.dof)};
            const auto [other, is_new] = values.emplace(place, value);
            if (!is_new && other->second != value)
                throw base::InputError("gives " + component_text(place.first, place.second) + " the value " +
                                       base::format_number(value) +
                                       ", where another load case of the load "
                                       "stage gives " +
                                       base::format_number(other->second));
            held_[place] = value;
        }
    });
}

void StageConditions::release(const LoadCase::Support& entry) {
    std::size_t released = 0;
    for (const Place& place : places_of(entry)) {
        claim(place, "free");
        if (!held_.contains(place)) continue;
        if (supported_.contains(place))
            throw base::InputError(component_text(place.first, place.second) +
                                   " is a support of the load case '" + plan_.supports->name +
                                   "', which stays; prescribe 0 to move it back");
        released += held_.erase(place);
    }
    if (released == 0)
        throw base::InputError("releases nothing: only what was prescribed or kept before can be released");
}

/// Supports without a prescribed value are held anyway.
void StageConditions::keep(const LoadCase::Support& entry, const mechanics::NodeValues& displacements) {
    for (const Place& place : places_of(entry)) {
        claim(place, "keep");
        if (supported_.contains(place) && !held_.contains(place)) continue;
        held_[place] = displacements(place.first, place.second);
    }
}

void StageConditions::prescribe(const LoadCase::PrescribedDisplacement& entry) {
    for (const auto node : select_some_nodes(entry.where, surface_.tessellation)) {
        const Place place{node.value, static_cast<int>(entry.dof)};
        const bool is_second = claims_.contains(place);
        claim(place, "prescribed");
        if (is_second && held_[place] != entry.value)
            throw base::InputError("gives " + component_text(place.first, place.second) + " the value " +
                                   base::format_number(entry.value) + ", where another entry gives " +
                                   base::format_number(held_[place]));
        held_[place] = entry.value;
    }
}

/// Refuse a component that two lists of a load stage name, because the order of the lists would matter.
void StageConditions::claim(const Place& place, std::string_view list) {
    const auto [claim, is_new] = claims_.emplace(place, list);
    if (!is_new && claim->second != list)
        throw base::InputError(component_text(place.first, place.second) + " is also in \"" +
                               std::string(claim->second) +
                               "\" of this load stage, where one of them is needed");
}

std::vector<StageConditions::Place> StageConditions::places_of(const LoadCase::Support& entry) const {
    std::vector<Place> places;
    for (const auto node : select_some_nodes(entry.where, surface_.tessellation)) {
        for (int d = 0; d < mechanics::kDofsPerNode; ++d)
            if (entry.fixed.contains[d]) places.emplace_back(node.value, d);
    }
    return places;
}

mechanics::NodeValues StageConditions::loads(std::size_t nodes) const {
    mechanics::NodeValues sum =
        mechanics::NodeValues::Zero(static_cast<Eigen::Index>(nodes), mechanics::kDofsPerNode);
    for (const auto& [name, factor] : factors_) {
        LoadCase part = stage_load_case(plan_, name);
        part.supports.clear();
        part.prescribed.clear();
        sum += factor * load_rows(resolve(part, surface_), nodes);
    }
    return sum;
}

LoadCase stage_load_case(const StagePlan& plan, const std::string& name) {
    return name == plan.supports->name ? *plan.supports
                                       : combined(load_case_of(name, plan.cases), plan.cases);
}

void check_stages(const Surface& surface, const StagePlan& plan) {
    check_names(plan.stages);
    const std::size_t nodes = surface.tessellation.interface_nodes.size();
    const mechanics::NodeValues at_rest =
        mechanics::NodeValues::Zero(static_cast<Eigen::Index>(nodes), mechanics::kDofsPerNode);
    StageConditions conditions(surface, plan);
    for (const LoadStage& stage : plan.stages) {
        check_entries(stage);
        (void)conditions.advance(stage, at_rest, nodes);
    }
}

}  // namespace fretwork::simulation

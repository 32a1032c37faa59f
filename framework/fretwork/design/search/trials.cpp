// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/search/free_section.hpp>
#include <fretwork/design/search/trials.hpp>
#include <fretwork/simulation/load_cases/conditions.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace fretwork::design::detail {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using mechanics::NodeValues;
using simulation::LoadCase;
using tiling::TileIndex;

}  // namespace

LoadCase with_factor(LoadCase load_case, double factor) {
    for (LoadCase::Load& load : load_case.loads) {
        load.force *= factor;
        load.moment *= factor;
    }
    for (LoadCase::AreaLoad& load : load_case.area_loads) load.per_area *= factor;
    return load_case;
}

Trials::Trials(TrialParts parts, const base::Control& control)
    : parts_(std::move(parts)),
      strains_(parts_.candidates, parts_.threads, control),
      setting_(parts_.surface.setting),
      candidate_setting_(parts_.surface.setting),
      aims_(parts_.cases.size()) {
    const auto nodes = parts_.surface.tessellation.interface_nodes.size();
    std::size_t goal_nodes = 0;
    for (const DesignCase& own : parts_.cases) {
        LoadCase weightless = own.load_case;
        weightless.gravity.setZero();
        unit_loads_.push_back(simulation::load_rows(simulation::resolve(weightless, parts_.surface), nodes));
        sessions_.emplace_back(
            parts_.surface, own.load_case,
            simulation::SimulationOptions{.model = "corotational", .threads = parts_.threads});
        largest_ = std::max(largest_, own.goals.largest());
        goal_nodes += own.goals.node_count();
    }
    scale_ = 1.0 / (largest_ * std::sqrt(static_cast<double>(goal_nodes)));
    const auto& candidates = parts_.candidates.patterns();
    for (const TileIndex tile : parts_.surface.tessellation.tiles.indices()) {
        const auto* own = tiling::pattern_of(parts_.surface.tessellation, tile);
        const auto place = std::ranges::find(candidates, own->id, &pattern::NamedPattern::id);
        if (place == candidates.end())
            throw base::InputError("tile " + std::to_string(tile.value) +
                                   " has a pattern that is no candidate");
        kept_.push_back(static_cast<std::size_t>(place - candidates.begin()));
    }
    painted_ = kept_;
}

VectorXd Trials::initial_unknowns() const {
    std::vector<double> values;
    for (const DesignCase& own : parts_.cases) {
        if (parts_.free.factor) values.push_back(1.0);
        if (!parts_.free.prescribed) continue;
        for (const auto& entry : own.load_case.prescribed) values.push_back(entry.value);
    }
    const mechanics::Section& section = parts_.surface.setting.section;
    if (parts_.free.width) values.push_back(mechanics::rectangle_width(section));
    if (parts_.free.thickness) values.push_back(mechanics::rectangle_height(section));
    return Eigen::Map<const VectorXd>(values.data(), std::ssize(values));
}

Point Trials::uniform(std::size_t pattern) const {
    return {std::vector<std::size_t>(parts_.groups.size(), pattern), initial_unknowns()};
}

VectorXd Trials::bounded(VectorXd unknowns) const {
    const Index first = first_of_section();
    const VectorXd initial = initial_unknowns().tail(unknowns.size() - first);
    unknowns.tail(initial.size()) = unknowns.tail(initial.size())
                                        .cwiseMax(initial / kLargestSectionChange)
                                        .cwiseMin(initial * kLargestSectionChange)
                                        .eval();
    return unknowns;
}

reduction::Setting Trials::setting_at(const Point& point) const {
    const reduction::Setting& given = parts_.surface.setting;
    if (!parts_.free.width && !parts_.free.thickness) return given;
    Index next = first_of_section();
    const double width =
        parts_.free.width ? point.unknowns[next++] : mechanics::rectangle_width(given.section);
    const double thickness =
        parts_.free.thickness ? point.unknowns[next] : mechanics::rectangle_height(given.section);
    return with_section(given, width, thickness);
}

Index Trials::first_unknown(std::size_t which) const {
    Index first = 0;
    for (std::size_t c = 0; c < which; ++c)
        first += (parts_.free.factor ? 1 : 0) +
                 (parts_.free.prescribed ? std::ssize(parts_.cases[c].load_case.prescribed) : 0);
    return first;
}

double Trials::factor_at(const Point& point, std::size_t which) const {
    return point.unknowns[first_unknown(which)];
}

LoadCase Trials::load_case_at(const Point& point, std::size_t which) const {
    Index next = first_unknown(which);
    LoadCase load_case = parts_.cases[which].load_case;
    if (parts_.free.factor) load_case = with_factor(std::move(load_case), point.unknowns[next++]);
    if (parts_.free.prescribed) {
        for (auto& entry : load_case.prescribed) entry.value = point.unknowns[next++];
    }
    return load_case;
}

std::vector<std::size_t> Trials::painting(const Point& point) const {
    std::vector<std::size_t> result = kept_;
    for (std::size_t g = 0; g < parts_.groups.size(); ++g) {
        for (const TileGroup::Member& member : parts_.groups[g].members)
            result[static_cast<std::size_t>(member.tile.value)] = member_pattern(member, point.patterns[g]);
    }
    return result;
}

std::set<std::size_t> Trials::possible(TileIndex tile, const std::vector<std::size_t>& palette) const {
    for (const TileGroup& group : parts_.groups) {
        for (const TileGroup::Member& member : group.members) {
            if (member.tile != tile) continue;
            std::set<std::size_t> patterns;
            for (const std::size_t pattern : palette) patterns.insert(member_pattern(member, pattern));
            return patterns;
        }
    }
    return {kept_[static_cast<std::size_t>(tile.value)]};
}

simulation::Surface Trials::surface_at(const Point& point) const {
    simulation::Surface surface = parts_.surface;
    surface.setting = setting_at(point);
    tiling::Tessellation& tessellation = surface.tessellation;
    const std::vector<std::size_t> wanted = painting(point);
    std::map<std::size_t, int> places;
    tessellation.patterns.clear();
    surface.calibrations.clear();
    for (std::size_t t = 0; t < wanted.size(); ++t) {
        const auto [entry, is_new] = places.try_emplace(wanted[t], static_cast<int>(places.size()));
        if (is_new) {
            tessellation.patterns.push_back(parts_.candidates.patterns()[wanted[t]]);
            surface.calibrations.emplace_back();
        }
        tessellation.tiles[t].pattern = entry->second;
    }
    return surface;
}

double Trials::mass_of(const Point& point) const {
    const std::vector<std::size_t> patterns = painting(point);
    double sum = 0.0;
    for (std::size_t t = 0; t < patterns.size(); ++t)
        sum += parts_.candidates.mass(parts_.candidates.class_of(TileIndex(t)), patterns[t]);
    if (point.unknowns.size() == 0) return sum;
    return sum * setting_at(point).section.area / candidate_setting_.section.area;
}

double Trials::group_mass(std::size_t group, std::size_t pattern) const {
    double mass = 0.0;
    for (const TileGroup::Member& member : parts_.groups[group].members)
        mass +=
            parts_.candidates.mass(parts_.candidates.class_of(member.tile), member_pattern(member, pattern));
    return mass;
}

Lightest Trials::lightest(const std::vector<std::size_t>& palette) const {
    Point point = uniform(palette.front());
    for (std::size_t g = 0; g < parts_.groups.size(); ++g)
        point.patterns[g] = *std::ranges::min_element(
            palette, {}, [&](std::size_t pattern) { return group_mass(g, pattern); });
    return {mass_of(point), point.patterns.front()};
}

void Trials::paint(const std::vector<std::size_t>& wanted) {
    std::map<std::size_t, std::vector<TileIndex>> changes;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
        if (wanted[t] != painted_[t]) changes[wanted[t]].emplace_back(t);
    }
    for (const auto& [pattern, tiles] : changes) {
        for (simulation::Session& session : sessions_)
            session.paint(tiles, parts_.candidates.patterns()[pattern].id);
    }
    painted_ = wanted;
}

void Trials::take_setting(const reduction::Setting& setting) {
    if (setting == setting_) return;
    for (simulation::Session& session : sessions_) session.set_setting(setting);
    setting_ = setting;
}

void Trials::refresh_candidates(const base::Control& control) {
    if (setting_ == candidate_setting_) return;
    condense(parts_.candidates.patterns(), control.silent());
}

void Trials::take_candidates(std::vector<pattern::NamedPattern> candidates, std::vector<std::size_t> mirrored,
                             const base::Control& control) {
    condense(std::move(candidates), control);
    parts_.mirrored = std::move(mirrored);
}

void Trials::condense(std::vector<pattern::NamedPattern> candidates, const base::Control& control) {
    simulation::Surface surface = parts_.surface;
    surface.setting = setting_;
    parts_.candidates = simulation::CandidateTiles(surface, std::move(candidates), {parts_.threads, control});
    strains_ = TileStrains(parts_.candidates, parts_.threads, control.silent());
    candidate_setting_ = setting_;
}

Trial Trials::solve(const Point& point, const base::Control& control) {
    at_.reset();
    paint(painting(point));
    take_setting(setting_at(point));
    Trial trial;
    trial.is_found = true;
    for (std::size_t c = 0; c < sessions_.size(); ++c) {
        const LoadCase wanted = load_case_at(point, c);
        if (wanted != sessions_[c].load_case()) sessions_[c].set_load_case(wanted);
        auto result = sessions_[c].solve(control.silent());
        ++solutions_;
        trial.is_found = trial.is_found && result.solution.is_stable_equilibrium();
        trial.displacements.push_back(std::move(result.solution.displacements));
    }
    if (!trial.is_found) return trial;
    trial.objective = objective(trial.displacements, aims_);
    at_ = point;
    return trial;
}

double Trials::objective(const std::vector<NodeValues>& displacements,
                         const std::vector<NodeValues>& aims) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < displacements.size(); ++c) {
        for (const Observation& own : parts_.cases[c].goals.observe(displacements[c], aims[c]))
            sum += own.weight * own.residual * own.residual;
    }
    return scale_ * scale_ * sum;
}

Trials::Distances Trials::distances(const std::vector<NodeValues>& displacements) const {
    Distances result;
    std::size_t count = 0;
    for (std::size_t c = 0; c < displacements.size(); ++c) {
        for (const double distance : parts_.cases[c].goals.distances(displacements[c])) {
            result.mean += distance / largest_;
            result.largest = std::max(result.largest, distance / largest_);
            ++count;
        }
    }
    result.mean /= static_cast<double>(count);
    return result;
}

double Trials::scaled_objective(const Trial& trial) const {
    double sum = 0.0;
    for (std::size_t c = 0; c < trial.displacements.size(); ++c) {
        const CaseGoals::Products own = parts_.cases[c].goals.products(trial.displacements[c]);
        const double multiple = own.there > 0.0 ? std::max(0.0, own.both / own.there) : 0.0;
        sum += own.wanted - 2.0 * multiple * own.both + multiple * multiple * own.there;
    }
    return scale_ * scale_ * sum;
}

}  // namespace fretwork::design::detail

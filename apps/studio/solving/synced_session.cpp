// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>
#include <fretwork/simulation/load_cases/load_case_file.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>
#include <map>

namespace fretwork::studio {
namespace {

using tiling::TileIndex;

/// The tiles of each change.
template <class Change>
using TilesBy = std::map<Change, std::vector<TileIndex>>;

bool have_same_ground(const State& a, const State& b) {
    return a.ground == b.ground && a.library == b.library && a.analysis == b.analysis;
}

/// The material's strength has no effect on the solution.
bool is_solved_alike(const reduction::Setting& a, const reduction::Setting& b) {
    return reduction::without_stresses(a) == reduction::without_stresses(b);
}

/// The page needs a processor, too, to show what was solved before.
int live_threads() {
    return std::max(1, base::resolved_thread_count(0) - 1);
}

}  // namespace

std::optional<library::Library> open_library(const State& state) {
    if (state.library->path.empty()) return std::nullopt;
    library::Library library = library::Library::open(state.library->path);
    if (!library.has_content(state.library->hash))
        throw base::InputError(
            state.library->path.string(), "",
            "has changed since the project was made: open the project with its own library, or "
            "choose material and section again");
    return library;
}

OpenedSurface open_surface(const State& state) {
    auto library = open_library(state);
    auto surface = simulation::make_surface(make_project(state, "/"), library ? &*library : nullptr);
    return {std::move(library), std::move(surface)};
}

simulation::LoadCase load_case_of(const Situation& situation) {
    const auto& cases = *situation.state->load_cases;
    if (situation.load_case >= cases.size())
        throw base::InputError("No load case yet. Add supports, then a load.");
    return simulation::combined(cases[situation.load_case], cases);
}

simulation::Session& SyncedSession::follow(const Situation& wanted) {
    try {
        if (session_ && have_same_ground(*now_.state, *wanted.state))
            edit(*now_.state, wanted);
        else
            begin(wanted);
    } catch (const base::Error&) {
        session_.reset();
        throw;
    }
    now_ = wanted;
    return *session_;
}

void SyncedSession::begin(const Situation& wanted) {
    const State& state = *wanted.state;
    session_.reset();
    OpenedSurface opened = open_surface(state);
    library_ = std::move(opened.library);
    const simulation::CalibrationSource source = [this](const std::string& pattern) {
        return library_ ? library_->best_calibrations(pattern) : std::vector<reduction::Calibration>{};
    };
    session_.emplace(std::move(opened.surface), load_case_of(wanted),
                     simulation::SimulationOptions{
                         .model = *state.model, .analysis = state.analysis, .threads = live_threads()},
                     source);
}

void SyncedSession::edit(const State& before, const Situation& wanted) {
    const State& now = *wanted.state;
    if (before.setting != now.setting && !is_solved_alike(*before.setting, *now.setting))
        session_->set_setting(*now.setting);
    if (before.painting != now.painting) paint(*before.painting, *now.painting);
    if (before.model != now.model && *before.model != *now.model) session_->set_model(*now.model);
    if (before.tile_models != now.tile_models) {
        TilesBy<std::string> chosen;
        for (std::size_t t = 0; t < now.tile_models->size(); ++t) {
            if ((*before.tile_models)[t] != (*now.tile_models)[t])
                chosen[(*now.tile_models)[t]].emplace_back(t);
        }
        for (const auto& [model, tiles] : chosen) session_->set_tile_model(tiles, model);
    }
    const simulation::LoadCase load_case = load_case_of(wanted);
    if (session_->load_case() != load_case) session_->set_load_case(load_case);
}

void SyncedSession::paint(const Painting& before, const Painting& now) {
    TilesBy<std::string> painted;
    TilesBy<int> turned;
    for (std::size_t t = 0; t < now.patterns.size(); ++t) {
        const auto id_of = [t](const Painting& painting) {
            return painting.patterns[t] < 0 ? std::string() : painting.palette[painting.patterns[t]].id;
        };
        const std::string id = id_of(now);
        if (id != id_of(before)) painted[id].emplace_back(t);
        if (before.turns[t] != now.turns[t]) turned[now.turns[t] - before.turns[t]].emplace_back(t);
    }
    if (painted.contains(""))
        throw base::InputError("tile " + std::to_string(painted.at("").front().value) +
                               " is not painted with a pattern");
    for (const auto& [id, tiles] : painted) session_->paint(tiles, id);
    for (const auto& [by, tiles] : turned) session_->turn(tiles, by);
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/facts.hpp>
#include <studio/solving/making_doubts.hpp>
#include <studio/solving/making_watch.hpp>
#include <studio/solving/rest.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::studio {
namespace {

/// Whether the same bars lie in the same places.
bool is_made_alike(const State& one, const State& other) {
    return one.ground == other.ground && one.painting == other.painting && one.setting == other.setting;
}

}  // namespace

void MakingWatch::begin() {
    looked_at_.reset();
    report_ = {};
    was_left_ = false;
}

void MakingWatch::follow(const State& now) {
    if (looked_at_ && !is_made_alike(*looked_at_, now)) was_left_ = true;
}

void MakingWatch::look_at(const Document& document) {
    const StatePtr& state = document.now();
    const bool was_left = std::exchange(was_left_, false);
    if (looked_at_ && is_made_alike(*looked_at_, *state)) {
        if (was_left) pages_.broadcast(report_);
        return;
    }
    thread_.cancel();
    looked_at_ = state;
    report_ = {};
    if (std::ranges::any_of(state->painting->patterns, [](int pattern) { return pattern < 0; })) return;
    const auto look = [this, state, revision = document.revision()](const base::Control& control) {
        rest(control);
        const MakingDoubts doubts = making_doubts(open_surface(*state).surface, {.control = control},
                                                  fabrication::FactsOptions().clearance);
        server_.post([this, state, event = making_event(doubts, revision)] { report(state, event); });
    };
    // The live solution already reports what cannot be built.
    thread_.add({.work = look, .failed = [](const std::string&) {}});
}

void MakingWatch::report(const StatePtr& state, const base::Json& event) {
    if (looked_at_ != state) return;
    report_ = {{json_part(event)}};
    if (is_made_alike(*state, *now_())) pages_.broadcast(report_);
}

void MakingWatch::send(ClientId client) {
    if (looked_at_ && is_made_alike(*looked_at_, *now_())) pages_.send(client, report_);
}

}  // namespace fretwork::studio

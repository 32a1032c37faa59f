// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/facts.hpp>
#include <studio/solving/making_doubts.hpp>
#include <studio/solving/making_watch.hpp>
#include <studio/solving/rest.hpp>
#include <studio/solving/synced_session.hpp>

#include <algorithm>

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
}

void MakingWatch::follow(const State& before) {
    const State& now = *now_();
    if (looked_at_ && is_made_alike(*looked_at_, now) && !is_made_alike(before, now))
        pages_.broadcast(report_);
}

void MakingWatch::look_at(const Document& document) {
    const StatePtr& state = document.now();
    if (looked_at_ && is_made_alike(*looked_at_, *state)) return;
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

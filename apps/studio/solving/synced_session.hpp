// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>
#include <fretwork/simulation/session.hpp>
#include <studio/document/state.hpp>

#include <optional>

namespace fretwork::studio {

/// A state and its selected load case.
struct Situation {
    StatePtr state;
    std::size_t load_case = 0;
    friend bool operator==(const Situation&, const Situation&) = default;
};

/// A session that follows a document. The differences from the state before become edits of the session,
/// which keeps everything else.
class SyncedSession {
  public:
    SyncedSession() = default;
    SyncedSession(const SyncedSession&) = delete;
    SyncedSession& operator=(const SyncedSession&) = delete;

    /// The session at this situation. Throws the errors of a session that refuses an edit; then the next call
    /// begins afresh.
    simulation::Session& follow(const Situation& wanted);
    /// As follow() left it.
    [[nodiscard]] const simulation::Session& operator*() const { return session_.value(); }

  private:
    void begin(const Situation& wanted);
    void edit(const State& before, const Situation& wanted);
    void paint(const Painting& before, const Painting& now);

    std::optional<library::Library> library_;
    std::optional<simulation::Session> session_;
    Situation now_{};
};

/// The surface of a state, and its library if it names one.
struct OpenedSurface {
    std::optional<library::Library> library;
    simulation::Surface surface;
};
/// Throws InputError if the library has changed, or is not there.
OpenedSurface open_surface(const State& state);
/// The library alone, without making the surface.
std::optional<library::Library> open_library(const State& state);
/// The selected load case, together with the load cases that it combines. Throws InputError that says what to
/// do if the document has no such load case.
simulation::LoadCase load_case_of(const Situation& situation);

}  // namespace fretwork::studio

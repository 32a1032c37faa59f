// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shared_object.hpp"

#include <fretwork/simulation/session.hpp>

#include <memory>
#include <vector>

namespace fretwork::python {

/// A session, and the tile models that it refers to.
struct OwnedSession {
    std::vector<reduction::TileModel> models;
    simulation::Session session;
};

using SessionObject = SharedObject<OwnedSession>;
using SessionPointer = std::shared_ptr<SessionObject>;

/// The solution of a result. Throws as Session::require_since_edit().
inline const mechanics::Solution& checked(const OwnedSession& session,
                                          const simulation::SurfaceResult& result) {
    session.session.require_since_edit(result.solution);
    return result.solution;
}

}  // namespace fretwork::python

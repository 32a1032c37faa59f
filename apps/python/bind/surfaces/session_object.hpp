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
    Eigen::Index rows = -1;  ///< rows of the last solution; -1: none since the last edit of tiles
};

using SessionObject = SharedObject<OwnedSession>;
using SessionPointer = std::shared_ptr<SessionObject>;

/// The solution of a result. Throws InputError if it has not as many rows as the session's last solution, or
/// if tiles were edited after that.
inline const mechanics::Solution& checked(const OwnedSession& session,
                                          const simulation::SurfaceResult& result) {
    if (result.solution.displacements.rows() != session.rows)
        throw base::InputError("this is no result that the session gave since its last edit");
    return result.solution;
}

}  // namespace fretwork::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/progress.hpp>

#include <functional>
#include <stop_token>

namespace fretwork::base {

/// Long work was asked to stop, and did: no result, and nothing half-written.
class Stopped : public Error {
  public:
    Stopped() : Error("stopped before it was done; nothing is half-written") {}
};

/// How a caller follows long work and ends it. Part of the options of everything that may take longer than a
/// tenth of a second.
struct Control {
    std::stop_token stop{};        ///< looked at at least every 50 ms; the default never asks to stop
    Progress* progress = nullptr;  ///< receives how far the work is; null: nobody listens. Not owned.
    /// Asked at every look, too, on whichever thread looks: true asks to stop. For a caller that has no
    /// second thread to ask from, and for tests. Null: nobody is asked. Not owned.
    const std::function<bool()>* question = nullptr;

    /// Whether the caller has asked to stop. Cheap enough for every iteration of a solver.
    [[nodiscard]] bool stop_wanted() const {
        return stop.stop_requested() || (question != nullptr && (*question)());
    }
    /// Throws Stopped if the caller has asked to stop.
    void check() const {
        if (stop_wanted()) throw Stopped();
    }
    /// A copy that can be stopped but reports no progress.
    [[nodiscard]] Control silent() const { return {.stop = stop, .question = question}; }
};

}  // namespace fretwork::base

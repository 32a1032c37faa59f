// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/progress.hpp>

#include <functional>
#include <stop_token>

namespace fretwork::base {

/// A long computation has stopped because its caller asked it to stop. The computation gives no result and
/// leaves nothing half-written.
class Stopped : public Error {
  public:
    /// Make the error.
    Stopped() : Error("stopped before it was done; nothing is half-written") {}
};

/// The means by which a caller follows a long computation and stops it. Most functions that may take longer
/// than a tenth of a second take a Control, in their options or as an argument.
struct Control {
    std::stop_token stop{};        ///< checked at least every 50 ms; the default never asks to stop
    Progress* progress = nullptr;  ///< receives the number of steps done; null: no reports. Not owned.
    /// A second way to stop, for callers without a second thread, and for tests. Most checks of `stop` also
    /// call this function, on the thread that checks; if it returns true, the computation stops. May be null.
    /// Not owned.
    const std::function<bool()>* question = nullptr;

    /// True if the caller has asked to stop. The call is cheap enough for every iteration of a solver.
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

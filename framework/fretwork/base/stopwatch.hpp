// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace fretwork::base {

/// A stopwatch that starts when it is made. Changes of the system's time do not affect it.
class Stopwatch {
  public:
    /// The time since the start, s.
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    }

  private:
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace fretwork::base

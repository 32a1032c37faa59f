// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fretwork::app {

/// Whether Ctrl-C or a polite kill has come while an InterruptGuard lived.
bool is_interrupted();

/// Ctrl-C and a polite kill only set the flag as long as this lives: what has begun is finished, what is done
/// is stored. A second Ctrl-C ends the program where it is.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

  private:
    void (*int_)(int);
    void (*term_)(int);
};

}  // namespace fretwork::app

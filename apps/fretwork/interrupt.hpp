// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <memory>

namespace fretwork::app {

/// From here on, outside of a LongWork, Ctrl-C (SIGINT) and SIGTERM end the program with one line and exit
/// code 1 instead of by the signal. A signal that is ignored stays ignored, also in a LongWork: a shell
/// starts the background jobs of a script with SIGINT ignored.
void end_in_order_when_interrupted();

/// Work that may take longer than a second. While it lives, Ctrl-C (SIGINT) or SIGTERM asks it to stop, and
/// its progress is shown on the terminal (nothing in a pipe). A second Ctrl-C, after at least 0.2 s, ends the
/// program at once; a second SIGTERM does nothing more.
///
/// A verb hands `control()` to the options of its long calls. A call that is stopped throws base::Stopped,
/// which `main` reports with exit code 1; or it returns its finished part, and `is_stopped` says why it is
/// not all. At most one LongWork may live at a time.
class LongWork {
  public:
    /// The signals that stop it: Ctrl-C and SIGTERM, or also SIGHUP, which comes when its terminal is closed.
    /// nohup starts a program with SIGHUP ignored, so that it goes on without a terminal.
    enum class StopsAt { Interrupt, HangUp };
    explicit LongWork(StopsAt signals = StopsAt::Interrupt);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    /// Refers to this object, which must live as long as the work.
    [[nodiscard]] base::Control control();
    [[nodiscard]] bool is_stopped() const;

  private:
    class SignalWatch;
    std::unique_ptr<SignalWatch> watch_;
    base::TerminalProgress progress_;
};

}  // namespace fretwork::app

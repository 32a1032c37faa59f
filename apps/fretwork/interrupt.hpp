// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <memory>

namespace fretwork::app {

/// From here on, Ctrl-C (SIGINT) and SIGTERM outside of a LongWork end the program with one line on standard
/// error and exit code 1. A signal that is ignored stays ignored, also in a LongWork: a shell starts the
/// background jobs of a script with SIGINT ignored.
void end_in_order_when_interrupted();

/// Work that may take longer than a second. While it lives, Ctrl-C (SIGINT) or SIGTERM asks it to stop, and
/// its progress is shown on the terminal (nothing in a pipe). A further Ctrl-C ends the program at once if it
/// comes more than 0.2 s after the first signal; a further SIGTERM has no effect.
///
/// A verb hands `control()` to the options of its long calls. A call that is stopped throws base::Stopped,
/// which `main` reports with exit code 1; or it returns the part that is done, and is_stopped() is then true.
/// At most one LongWork may live at a time.
class LongWork {
  public:
    /// The signals that stop the work. Interrupt: Ctrl-C and SIGTERM. HangUp: also SIGHUP, which comes when
    /// the terminal is closed. nohup starts a program with SIGHUP ignored, so that the program goes on
    /// without a terminal.
    enum class StopsAt { Interrupt, HangUp };
    explicit LongWork(StopsAt signals = StopsAt::Interrupt);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    /// The control for long calls. It refers to this LongWork, which must outlive the calls.
    [[nodiscard]] base::Control control();
    [[nodiscard]] bool is_stopped() const;

  private:
    class SignalWatch;
    std::unique_ptr<SignalWatch> watch_;
    base::TerminalProgress progress_;
};

}  // namespace fretwork::app

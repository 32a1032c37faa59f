// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <optional>
#include <string>
#include <sys/types.h>

namespace fretwork::optimization::detail {

/// A shell command that runs beside us. Its standard input and output are one socket, on which both sides
/// speak in lines; its standard error is ours. It has a process group of its own, so that Ctrl-C reaches this
/// program alone, which then ends the command.
class ChildProcess {
  public:
    /// Start the command. The control stops all waiting for it within 50 ms. Throws IoError.
    ChildProcess(const std::string& command, const base::Control& control);
    /// Kills what still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Its next line, without the end of line, LF or CR LF; none at the end of its output. Throws InputError
    /// if a line does not end, Stopped.
    std::optional<std::string> read_line();
    /// Write a line. One that the command no longer reads is lost. Throws Stopped.
    void write_line(const std::string& text);
    /// Say that no more lines come, and wait a second for the end of the command. Then the command and all
    /// that it has started are killed. Returns its exit code, or that of a shell whose command was killed by
    /// a signal: 128 and its number; none if it had not ended by itself.
    std::optional<int> finish();

  private:
    void wait_for(short event) const;

    base::Control control_;
    int socket_ = -1;
    pid_t process_ = 0;  ///< 0: it has ended
    std::string unread_;
};

}  // namespace fretwork::optimization::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>

namespace fretwork::optimization::detail {

/// A shell command that runs beside this program. Its standard input and output are one socket, on which both
/// sides write lines; it shares the standard error of this program. It has a process group of its own, so
/// that Ctrl-C reaches only this program, which then ends the command.
class ChildProcess {
  public:
    /// Start the command. The control stops all waiting for it within 50 ms. Throws IoError.
    ChildProcess(const std::string& command, const base::Control& control);
    /// Kills the command and its process group, unless finish() has ended them.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// The command's next line, without the LF or CR LF at its end; none at the end of the output, where a
    /// line without LF is dropped, or once `gives_up`, which is asked while the command is silent, returns
    /// true. Throws InputError if a line is longer than a mebibyte. Throws Stopped.
    std::optional<std::string> read_line(const std::function<bool()>& gives_up);
    /// Write a line. While the command does not read, what it writes is kept for read_line(), up to a
    /// mebibyte: a command may write many lines before it reads one. A line that the command no longer reads
    /// is lost, and so is the rest of a line once `gives_up`, which is asked while the command does not read,
    /// returns true. Throws Stopped.
    void write_line(const std::string& text, const std::function<bool()>& gives_up);
    /// True if the command has written a mebibyte that read_line() has not returned. It may wait until this
    /// program reads on.
    [[nodiscard]] bool is_full() const { return kept() >= kLongestLine; }
    /// Close the command's input, wait up to a second until the command ends, and kill the rest of its
    /// process group. Returns the command's exit code, or 128 plus the number of the signal that ended the
    /// command; none if the command did not end within the second. Throws Stopped.
    std::optional<int> finish();

  private:
    static constexpr std::size_t kLongestLine =
        1 << 20;  ///< also the most that is kept while a line is written

    /// Wait for an event on the socket. Returns false if the wait was given up.
    bool wait_for(short event, const std::function<bool()>& gives_up) const;
    /// Append to `unread_` what the command has written, if anything. Returns false at the end of its output.
    bool receive();
    /// Number of characters that the command has written and read_line() has not returned.
    [[nodiscard]] std::size_t kept() const { return unread_.size() - next_; }

    base::Control control_;
    int socket_ = -1;
    pid_t process_ = 0;  ///< 0: it has ended
    std::string unread_;
    std::size_t next_ = 0;  ///< begin of the next line in `unread_`
};

}  // namespace fretwork::optimization::detail

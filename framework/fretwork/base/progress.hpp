// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace fretwork::base {

/// A receiver of progress. Implementations are called from one thread at a time.
class Progress {
  public:
    virtual ~Progress() = default;
    /// Begin a task of `total` steps.
    virtual void start(std::string_view task, std::size_t total) = 0;
    /// Report that `done` of the steps are done.
    virtual void update(std::size_t done) = 0;
    /// End the task.
    virtual void finish() = 0;
};

/// A receiver that shows nothing.
class SilentProgress final : public Progress {
  public:
    void start(std::string_view, std::size_t) override {}
    void update(std::size_t) override {}
    void finish() override {}
};

/// A receiver that draws one line on a terminal, in place, with the share of the steps done, the rate and the
/// estimated time left. Nothing is drawn if the stream is not a terminal, or for tasks of less than half a
/// second.
class TerminalProgress final : public Progress {
  public:
    /// Show progress on a stream, if it is a terminal.
    explicit TerminalProgress(std::FILE* stream = stderr);
    /// Ends the line of a task that an exception left unfinished.
    ~TerminalProgress() override { end_line(); }
    TerminalProgress(const TerminalProgress&) = delete;
    TerminalProgress& operator=(const TerminalProgress&) = delete;
    void start(std::string_view task, std::size_t total) override;
    void update(std::size_t done) override;
    void finish() override;

  private:
    using Clock = std::chrono::steady_clock;
    void draw(std::size_t done);
    void end_line();

    std::FILE* stream_;
    bool is_terminal_;
    bool is_line_open_ = false;
    std::string task_;
    std::size_t total_ = 0;
    std::size_t done_ = 0;
    Clock::time_point started_;
    Clock::time_point drawn_;
};

}  // namespace fretwork::base

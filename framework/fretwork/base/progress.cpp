// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/progress.hpp>

#include <algorithm>
#include <unistd.h>

namespace fretwork::base {
namespace {

constexpr std::chrono::milliseconds kDelay(500);  ///< until the line is drawn for the first time
constexpr std::chrono::milliseconds kPause(100);  ///< between two drawings

}  // namespace

TerminalProgress::TerminalProgress(std::FILE* stream)
    : stream_(stream), is_terminal_(::isatty(::fileno(stream)) == 1) {}

void TerminalProgress::start(std::string_view task, std::size_t total) {
    task_ = task;
    total_ = std::max<std::size_t>(total, 1);
    done_ = 0;
    end_line();
    started_ = Clock::now();
    drawn_ = started_ + kDelay - kPause;
}

void TerminalProgress::update(std::size_t done) {
    done_ = done;
    if (Clock::now() - drawn_ >= kPause) draw(done);
}

void TerminalProgress::finish() {
    if (is_line_open_) draw(done_);
    end_line();
}

void TerminalProgress::end_line() {
    if (!is_line_open_) return;
    is_line_open_ = false;
    std::fputc('\n', stream_);
    std::fflush(stream_);
}

void TerminalProgress::draw(std::size_t done) {
    drawn_ = Clock::now();
    if (!is_terminal_) return;
    is_line_open_ = true;
    const double seconds = std::chrono::duration<double>(drawn_ - started_).count();
    const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0.0;
    std::fprintf(stream_, "\r%s  %3zu %%  %zu / %zu", task_.c_str(), 100 * done / total_, done, total_);
    if (rate > 0) {
        std::fprintf(stream_, "  %.3g/s  %.0f s left", rate,
                     static_cast<double>(total_ - std::min(done, total_)) / rate);
    }
    std::fputs("\x1b[K", stream_);
    std::fflush(stream_);
}

}  // namespace fretwork::base

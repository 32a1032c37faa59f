// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace fretwork::app {
namespace {

// Read by threads, written by a signal handler: both need it free of locks.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void note_interrupt(int signal) {
    interrupted = true;
    std::signal(signal, SIG_DFL);
}

}  // namespace

bool is_interrupted() {
    return interrupted;
}

InterruptGuard::InterruptGuard()
    : int_(std::signal(SIGINT, note_interrupt)), term_(std::signal(SIGTERM, note_interrupt)) {}

InterruptGuard::~InterruptGuard() {
    std::signal(SIGINT, int_);
    std::signal(SIGTERM, term_);
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"
#include "verbs.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <semaphore.h>
#include <stop_token>
#include <string_view>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace fretwork::app {
namespace {

// A signal handler may do little more than post a semaphore, so a thread waits for that and requests the
// stop. Blocking the signals and waiting for them with sigwait is not enough: libraries start their own
// threads before main, and a signal that one of those receives ends the program.
sem_t signal_has_come;

/// When the first signal came, in nanoseconds; 0: none yet.
std::atomic<std::int64_t> first_signal = 0;
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t nanoseconds_now() {
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

/// The least time between two Ctrl-C of a person, in nanoseconds. Programs such as timeout(1) signal both a
/// process and its group, so that two signals come within microseconds. A second SIGTERM does nothing:
/// whoever wants to end the program at once has SIGKILL.
constexpr std::int64_t kLeastPause = 200'000'000;

extern "C" void note_signal(int signal) {
    const int error = errno;
    const std::int64_t now = nanoseconds_now();
    std::int64_t first = 0;
    if (first_signal.compare_exchange_strong(first, now)) {
        ::sem_post(&signal_has_come);
    } else if (signal == SIGINT && now - first > kLeastPause) {
        std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
    errno = error;
}

extern "C" void end_in_order(int) {
    constexpr std::string_view kLine = "fretwork: stopped before it was done; nothing is half-written\n";
    const ssize_t ignored = ::write(STDERR_FILENO, kLine.data(), kLine.size());
    (void)ignored;
    ::_exit(static_cast<int>(ExitCode::DidNotSucceed));
}

}  // namespace

void end_in_order_when_interrupted() {
    for (const int signal : {SIGINT, SIGTERM}) {
        if (std::signal(signal, end_in_order) == SIG_IGN) std::signal(signal, SIG_IGN);
    }
}

/// Turns the first signal into a request to stop.
class LongWork::SignalWatch {
  public:
    explicit SignalWatch(StopsAt signals)
        : signals_(signals == StopsAt::HangUp ? std::vector{SIGINT, SIGTERM, SIGHUP}
                                              : std::vector{SIGINT, SIGTERM}) {
        first_signal = 0;
        ::sem_init(&signal_has_come, 0, 0);
        try {
            waiting_ = std::thread([this] {
                while (::sem_wait(&signal_has_come) != 0) continue;
                source_.request_stop();
            });
        } catch (const std::system_error&) {
            return;  // The machine gives no more threads: a signal ends the program, as it does without this.
        }
        for (const int signal : signals_) {
            handlers_.push_back(std::signal(signal, note_signal));
            if (handlers_.back() == SIG_IGN) std::signal(signal, SIG_IGN);
        }
    }
    ~SignalWatch() {
        if (!waiting_.joinable()) return;
        for (std::size_t i = 0; i < signals_.size(); ++i) std::signal(signals_[i], handlers_[i]);
        ::sem_post(&signal_has_come);
        waiting_.join();
    }
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }

  private:
    std::vector<int> signals_;
    std::stop_source source_;
    std::thread waiting_;
    std::vector<void (*)(int)> handlers_;
};

LongWork::LongWork(StopsAt signals) : watch_(std::make_unique<SignalWatch>(signals)) {}

LongWork::~LongWork() = default;

base::Control LongWork::control() {
    return {.stop = watch_->token(), .progress = &progress_};
}

bool LongWork::is_stopped() const {
    return watch_->token().stop_requested();
}

}  // namespace fretwork::app

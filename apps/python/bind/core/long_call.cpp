// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/long_call.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace fretwork::python {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBetweenLooks = std::chrono::milliseconds(10);
constexpr auto kBetweenReports = std::chrono::milliseconds(50);

/// Raises a flag when SIGINT arrives, and hands the signal on to Python's own handler. One watch at a time.
class InterruptWatch {
  public:
    InterruptWatch() {
        if (sigaction(SIGINT, nullptr, &before_) != 0 || !has_handler(before_)) return;
        next_handler = before_.sa_handler;
        arrived = 0;
        struct sigaction watching = before_;
        watching.sa_handler = [](int signal) {
            arrived = 1;
            next_handler(signal);
        };
        is_watching_ = sigaction(SIGINT, &watching, nullptr) == 0;
    }
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;
    ~InterruptWatch() {
        if (is_watching_) sigaction(SIGINT, &before_, nullptr);
    }
    [[nodiscard]] static bool has_arrived() { return arrived != 0; }
    static void forget() { arrived = 0; }

  private:
    static bool has_handler(const struct sigaction& action) {
        return (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler != SIG_IGN &&
               action.sa_handler != SIG_DFL;
    }
    static inline std::atomic<int> arrived = 0;
    static inline void (*next_handler)(int) = nullptr;
    struct sigaction before_ {};
    bool is_watching_ = false;
};

bool is_main_thread() {
    const py::module_ threading = py::module_::import("threading");
    return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

/// A callback of a long call may begin another long call, and watches must not nest.
thread_local int depth = 0;

}  // namespace

class LongCall::Impl : public base::Progress {
  public:
    explicit Impl(py::object progress) : progress_(std::move(progress)), caller_(std::this_thread::get_id()) {
        if (progress_.is(py::bool_(true)))
            progress_ = py::module_::import("fretwork._progress").attr("Bar")();
        else if (!progress_.is_none() && PyCallable_Check(progress_.ptr()) == 0)
            throw py::type_error("progress is None, True, or a function of task, steps done and all steps");
        is_counted_ = is_main_thread();
        if (is_counted_ && depth++ == 0) watch_.emplace();
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() override {
        if (is_counted_) --depth;
    }

    [[nodiscard]] base::Control control() {
        base::Progress* listener = progress_.is_none() ? nullptr : this;
        return {.progress = listener, .question = &question_};
    }

    void start(std::string_view task, std::size_t total) override {
        task_ = task;
        total_ = total;
        report(0);
    }
    void update(std::size_t done) override {
        if (Clock::now() - reported_ >= kBetweenReports || done == total_) report(done);
    }
    void finish() override {}

    void raise_kept() {
        if (raised_) throw py::error_already_set(*raised_);
    }

    void forget_interrupt() {
        const py::gil_scoped_acquire acquired;
        if (PyErr_CheckSignals() != 0) keep_raised();
        const std::lock_guard lock(mutex_);
        if (!raised_ || !raised_->matches(PyExc_KeyboardInterrupt)) return;
        raised_.reset();
        has_raised_.store(false);
    }

  private:
    /// Whether the work is to stop. Runs on any of its threads.
    bool ask() {
        if (has_raised_.load()) return true;
        if (std::this_thread::get_id() != caller_) return watch_ && InterruptWatch::has_arrived();
        const auto now = Clock::now();
        if (now - looked_ < kBetweenLooks) return false;
        looked_ = now;
        const py::gil_scoped_acquire acquired;
        if (PyErr_CheckSignals() == 0) {
            InterruptWatch::forget();
            return false;
        }
        keep_raised();
        return true;
    }
    void report(std::size_t done) {
        if (has_raised_.load()) return;
        reported_ = Clock::now();
        const py::gil_scoped_acquire acquired;
        try {
            progress_(task_, done, total_);
        } catch (py::error_already_set& error) {
            error.restore();
            keep_raised();
        }
    }
    /// Keeps the error that Python has set, for the end of the call.
    void keep_raised() {
        const std::lock_guard lock(mutex_);
        if (raised_) return PyErr_Clear();
        raised_.emplace();
        has_raised_.store(true);
    }

    py::object progress_;
    std::thread::id caller_;
    bool is_counted_ = false;
    std::optional<InterruptWatch> watch_;
    std::function<bool()> question_ = [this] { return ask(); };
    Clock::time_point looked_ = Clock::now();
    Clock::time_point reported_{};
    std::string task_;
    std::size_t total_ = 0;
    std::mutex mutex_;
    std::optional<py::error_already_set> raised_;
    std::atomic<bool> has_raised_ = false;
};

LongCall::LongCall(py::object progress) : impl_(std::make_unique<Impl>(std::move(progress))) {}
LongCall::~LongCall() = default;

base::Control LongCall::control() const {
    return impl_->control();
}

void LongCall::raise_kept() {
    impl_->raise_kept();
}

void LongCall::forget_interrupt() {
    impl_->forget_interrupt();
}

void LongCall::raise_pending() {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

}  // namespace fretwork::python

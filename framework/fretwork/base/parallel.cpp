// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace fretwork::base {
namespace {

/// The first failure by index, whichever thread meets it first.
class FirstFailure {
  public:
    void record(std::size_t index) {
        const std::lock_guard lock(mutex_);
        if (exception_ && index_ < index) return;
        index_ = index;
        exception_ = std::current_exception();
    }
    void rethrow_if_any() const {
        if (exception_) std::rethrow_exception(exception_);
    }

  private:
    std::mutex mutex_;
    std::exception_ptr exception_;
    std::size_t index_ = 0;
};

}  // namespace

int resolved_thread_count(int wanted) {
    return wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    FirstFailure failure;
    const auto work = [&] {
        for (;;) {
            // Indices are handed out in order, so all below a failed one have been started: the smallest
            // failure is met.
            if (failed.load()) return;
            const std::size_t index = next.fetch_add(1);
            if (index >= count) return;
            try {
                body(index);
            } catch (...) {
                failure.record(index);
                failed.store(true);
            }
        }
    };
    const std::size_t helpers =
        std::min<std::size_t>(resolved_thread_count(threads), std::max<std::size_t>(count, 1)) - 1;
    {
        std::vector<std::jthread> pool;
        pool.reserve(helpers);
        for (std::size_t i = 0; i < helpers; ++i) pool.emplace_back(work);
        work();
    }
    failure.rethrow_if_any();
}

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace fretwork::base {
namespace {

constexpr std::size_t kMostThreads = 256;

/// Keeps the exception of the call with the smallest index.
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

/// Calls the body for the nodes of a tree, children before parents.
class TreeWork {
  public:
    TreeWork(std::span<const int> parent, const std::function<void(std::size_t)>& body)
        : parent_(parent),
          body_(body),
          waits_for_(parent.size(), 0),
          is_spoiled_(parent.size(), false),
          unfinished_(parent.size()) {
        for (const int above : parent_) {
            if (above >= 0) ++waits_for_[above];
        }
        for (std::size_t i = parent_.size(); i-- > 0;) {
            if (waits_for_[i] == 0) ready_.push_back(i);
        }
    }

    void run() {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [&] { return !ready_.empty() || unfinished_ == 0; });
            if (unfinished_ == 0) return;
            const std::size_t index = ready_.back();
            ready_.pop_back();
            if (!is_spoiled_[index]) {
                lock.unlock();
                const bool succeeded = call(index);
                lock.lock();
                is_spoiled_[index] = !succeeded;
            }
            finish(index);
        }
    }

    void rethrow_if_any() const { failure_.rethrow_if_any(); }

  private:
    bool call(std::size_t index) {
        try {
            body_(index);
            return true;
        } catch (...) {
            failure_.record(index);
            return false;
        }
    }

    void finish(std::size_t index) {
        if (--unfinished_ == 0) changed_.notify_all();
        if (parent_[index] < 0) return;
        const std::size_t above = parent_[index];
        if (is_spoiled_[index]) is_spoiled_[above] = true;
        if (--waits_for_[above] > 0) return;
        ready_.push_back(above);
        changed_.notify_one();
    }

    std::span<const int> parent_;
    const std::function<void(std::size_t)>& body_;
    std::vector<int> waits_for_;
    std::vector<bool> is_spoiled_;  ///< true: the call for the node, or for one below it, has thrown
    std::vector<std::size_t> ready_;
    std::size_t unfinished_;
    std::mutex mutex_;
    std::condition_variable changed_;
    FirstFailure failure_;
};

/// Threads that are kept from one call to the next, because starting a thread takes as long as factorizing a
/// small matrix. Every caller may share its work with them, and waits only for threads that have begun it.
class Helpers {
  public:
    Helpers() = default;
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;
    ~Helpers() {
        {
            const std::lock_guard lock(mutex_);
            is_ending_ = true;
        }
        offered_.notify_all();
    }

    /// Run `work` on this thread, and on up to `wanted` others.
    void share(std::size_t wanted, const std::function<void()>& work) {
        Offer offer{work, wanted};
        {
            const std::lock_guard lock(mutex_);
            offers_.push_back(&offer);
            start_threads();
        }
        offered_.notify_all();
        work();
        std::unique_lock lock(mutex_);
        std::erase(offers_, &offer);
        ended_.wait(lock, [&] { return offer.helping == 0; });
    }

  private:
    struct Offer {
        const std::function<void()>& work;
        std::size_t wanted;  ///< number of threads that may still join
        std::size_t helping = 0;
    };

    /// Start the wanted threads beyond the idle ones.
    void start_threads() {
        std::size_t wanted = 0;
        for (const Offer* offer : offers_) wanted += offer->wanted;
        try {
            for (; idle_ < wanted && threads_.size() < kMostThreads; ++idle_)
                threads_.emplace_back([this] { help(); });
        } catch (const std::system_error&) {
            // The system starts no more threads, so the present threads do all of the work.
        }
    }

    void help() {
        std::unique_lock lock(mutex_);
        for (;; ++idle_) {
            offered_.wait(lock, [&] { return is_ending_ || !offers_.empty(); });
            --idle_;
            if (is_ending_) return;
            Offer& offer = *offers_.front();
            if (--offer.wanted == 0) offers_.erase(offers_.begin());
            ++offer.helping;
            lock.unlock();
            offer.work();
            lock.lock();
            if (--offer.helping == 0) ended_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable offered_;
    std::condition_variable ended_;
    std::vector<Offer*> offers_;  ///< open offers
    std::size_t idle_ = 0;        ///< number of threads that wait for an offer or will do so next
    bool is_ending_ = false;
    std::vector<std::jthread> threads_;  ///< last member, so the threads end before the other members
};

/// Run `work` on this thread and on as many others as are useful for `count` pieces.
void run_on_threads(std::size_t count, int threads, const std::function<void()>& work) {
    static Helpers helpers;
    const std::size_t useful =
        std::min<std::size_t>(resolved_thread_count(threads), std::max<std::size_t>(count, 1));
    if (useful == 1) return work();
    helpers.share(useful - 1, work);
}

}  // namespace

int resolved_thread_count(int wanted) {
    // hardware_concurrency() opens a file at each call, so it is called once.
    static const int present = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return std::min(wanted > 0 ? wanted : present, static_cast<int>(kMostThreads));
}

void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> failed{false};
    FirstFailure failure;
    const auto work = [&] {
        for (;;) {
            // Indices are handed out in order, so all calls below a failed index have begun. The failure with
            // the smallest index is therefore recorded.
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
    run_on_threads(count, threads, work);
    failure.rethrow_if_any();
}

void parallel_tree(std::span<const int> parent, int threads, const std::function<void(std::size_t)>& body) {
    if (parent.size() == 1) return body(0);
    TreeWork tree(parent, body);
    run_on_threads(parent.size(), threads, [&] { tree.run(); });
    tree.rethrow_if_any();
}

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/control.hpp>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace fretwork::studio {

/// A thread that does one piece of work after the other.
class Background {
  public:
    /// A piece of work. If it throws a std::exception, `failed` receives words for people, on the thread.
    struct Job {
        std::function<void(const base::Control&)> work;
        std::function<void(const std::string& error)> failed;
        /// Receives the share done, 0 to 1; may be empty.
        std::function<void(double share)> progress{};
    };
    /// The largest number of waiting jobs; more are refused.
    static constexpr std::size_t kMostWaiting = 16;

    Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    /// Stops the running job.
    ~Background();

    /// Throws InputError if too many are waiting.
    void add(Job job);
    /// Stop the running job and forget the waiting ones; each is reported as failed.
    void cancel();

  private:
    void run(const std::stop_token& ending);
    void work(const Job& job, const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Job> waiting_;
    std::stop_source stop_;  ///< of the job under way
    std::jthread thread_;
};

}  // namespace fretwork::studio

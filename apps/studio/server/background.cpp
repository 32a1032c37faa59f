// SPDX-License-Identifier: GPL-3.0-or-later
#include <studio/server/background.hpp>
#include <studio/server/progress.hpp>
#include <studio/server/words.hpp>

#include <optional>
#include <utility>

namespace fretwork::studio {
namespace {

const std::string kCancelled = "cancelled";

}  // namespace

Background::Background() : thread_([this](const std::stop_token& ending) { run(ending); }) {}

Background::~Background() {
    thread_.request_stop();
    const std::scoped_lock lock(mutex_);
    stop_.request_stop();
}

void Background::add(Job job) {
    const std::scoped_lock lock(mutex_);
    if (waiting_.size() >= kMostWaiting)
        throw base::InputError("too much work is waiting already; cancel it, or try again later");
    waiting_.push_back(std::move(job));
    changed_.notify_one();
}

void Background::cancel() {
    std::deque<Job> forgotten;
    {
        const std::scoped_lock lock(mutex_);
        stop_.request_stop();
        forgotten = std::exchange(waiting_, {});
    }
    for (const Job& job : forgotten) job.failed(kCancelled);
}

void Background::run(const std::stop_token& ending) {
    while (true) {
        std::optional<Job> job;
        std::stop_token stop;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, ending, [this] { return !waiting_.empty(); })) return;
            if (ending.stop_requested()) return;
            job = std::move(waiting_.front());
            waiting_.pop_front();
            stop_ = std::stop_source();
            stop = stop_.get_token();
        }
        work(*job, stop);
    }
}

void Background::work(const Job& job, const std::stop_token& stop) {
    ShareProgress progress(job.progress);
    try {
        job.work({.stop = stop, .progress = &progress});
    } catch (const base::Stopped&) {
        job.failed(kCancelled);
    } catch (...) {
        job.failed(one_line(error_in_words()));
    }
}

}  // namespace fretwork::studio

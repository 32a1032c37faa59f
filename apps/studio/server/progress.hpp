// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/progress.hpp>

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace fretwork::studio {

/// Tells at most ten times a second how far work is, and nothing of work that is done at once.
class ToldProgress final : public base::Progress {
  public:
    /// The task and the share of it that is done, 0 to 1.
    using Tell = std::function<void(const std::string& task, double share)>;
    explicit ToldProgress(Tell tell) : tell_(std::move(tell)) {}

    void start(std::string_view task, std::size_t total) override {
        task_ = task;
        total_ = total;
        told_ = Clock::now() + kSilent - kPause;
    }
    void update(std::size_t done) override {
        const auto now = Clock::now();
        if (now - told_ < kPause || total_ == 0) return;
        told_ = now;
        tell_(task_, static_cast<double>(done) / static_cast<double>(total_));
    }
    void finish() override {}

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kSilent{200};
    static constexpr std::chrono::milliseconds kPause{100};

    Tell tell_;
    std::string task_;
    std::size_t total_ = 0;
    Clock::time_point told_{};
};

}  // namespace fretwork::studio

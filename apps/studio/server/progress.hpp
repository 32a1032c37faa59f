// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/progress.hpp>

#include <chrono>
#include <functional>
#include <string_view>

namespace fretwork::studio {

/// Reports at most ten times a second how far work is, but not in the first 0.2 s.
class ShareProgress final : public base::Progress {
  public:
    /// The share of the work that is done, 0 to 1. May be empty.
    using Report = std::function<void(double share)>;
    explicit ShareProgress(Report report) : report_(std::move(report)) {}

    void start(std::string_view /*task*/, std::size_t total) override {
        total_ = total;
        reported_ = Clock::now() + kSilent - kPause;
    }
    void update(std::size_t done) override {
        const auto now = Clock::now();
        if (now - reported_ < kPause || total_ == 0 || !report_) return;
        reported_ = now;
        report_(static_cast<double>(done) / static_cast<double>(total_));
    }
    void finish() override {}

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kSilent{200};
    static constexpr std::chrono::milliseconds kPause{100};

    Report report_;
    std::size_t total_ = 0;
    Clock::time_point reported_{};
};

}  // namespace fretwork::studio

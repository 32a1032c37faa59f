// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/random.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <studio/layouts/layout_count.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::studio {
namespace {

using Clock = std::chrono::steady_clock;
using pattern::Pattern;

/// Draws some of a stream of patterns, each of those seen with the same chance [Vitter1985, algorithm R]. The
/// same stream gives the same sample.
class Drawn {
  public:
    explicit Drawn(std::size_t most) : most_(most) {}

    void take(const Pattern& pattern) {
        const std::uint64_t number = seen_++;
        if (kept_.size() < most_) {
            kept_.emplace_back(number, pattern);
        } else if (most_ > 0) {
            const std::uint64_t place = random_.below(seen_);
            if (place < most_) kept_[place] = {number, pattern};
        }
    }
    [[nodiscard]] std::uint64_t seen() const { return seen_; }
    [[nodiscard]] std::vector<Pattern> in_order() {
        std::ranges::sort(kept_, {}, &std::pair<std::uint64_t, Pattern>::first);
        std::vector<Pattern> patterns;
        for (const auto& [number, pattern] : kept_) patterns.push_back(pattern);
        return patterns;
    }

  private:
    std::size_t most_;
    std::uint64_t seen_ = 0;
    std::vector<std::pair<std::uint64_t, Pattern>> kept_;
    base::SplitMix64 random_{1};
};

/// Tells a number from time to time.
class Teller {
  public:
    explicit Teller(const std::function<void(std::uint64_t)>& tell) : tell_(tell) {}
    void see(std::uint64_t found) {
        constexpr std::uint64_t kLookAtClock = 4096;
        if (!tell_ || found % kLookAtClock != 0) return;
        const auto now = Clock::now();
        if (now < next_) return;
        next_ = now + kPause;
        tell_(found);
    }

  private:
    static constexpr std::chrono::milliseconds kPause{200};
    const std::function<void(std::uint64_t)>& tell_;
    Clock::time_point next_ = Clock::now() + kPause;
};

}  // namespace

CountedPatterns counted(const pattern::NodeLayout& layout, const CountLimits& limits,
                        const base::Control& control, const std::function<void(std::uint64_t)>& tell) {
    const Clock::time_point end = Clock::now() + limits.time;
    const std::function<bool()> is_over = [&control, end] {
        return control.stop_wanted() || Clock::now() >= end;
    };
    const pattern::EnumerationOptions options{.edges = pattern::default_edge_range(layout),
                                              .control = {.stop = control.stop, .question = &is_over}};
    Drawn drawn(limits.samples);
    Teller teller(tell);
    CountedPatterns result;
    try {
        pattern::for_each_pattern(layout, options, [&](const Pattern& pattern) {
            if (drawn.seen() == limits.patterns) throw base::Stopped();
            drawn.take(pattern);
            teller.see(drawn.seen());
        });
    } catch (const base::Stopped&) {
        // The patterns found so far are kept, unless the caller has stopped the count.
        control.check();
        result.is_complete = false;
    }
    result.patterns = drawn.seen();
    result.samples = drawn.in_order();
    return result;
}

}  // namespace fretwork::studio

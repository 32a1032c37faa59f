// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"
#include "stops.hpp"

#include <fretwork/tiling/tessellate.hpp>

namespace fretwork::tiling {
namespace THIS_TEST {

/// Counts the updates, and asks to stop after a given number.
class Listener final : public base::Progress {
  public:
    explicit Listener(std::size_t updates_before_stop = SIZE_MAX) : left_(updates_before_stop) {}
    void start(std::string_view, std::size_t total) override {
        total_ = total;
        ++started_;
    }
    void update(std::size_t done) override {
        EXPECT_GE(done, done_);
        done_ = done;
        if (left_-- == 0) source_.request_stop();
    }
    void finish() override { ++finished_; }
    [[nodiscard]] base::Control control() { return {.stop = source_.get_token(), .progress = this}; }

    std::size_t total_ = 0;
    std::size_t done_ = 0;
    int started_ = 0;
    int finished_ = 0;

  private:
    std::size_t left_;
    std::stop_source source_;
};

TessellationResult tile(const outlines::Outline& outline, const base::Control& control) {
    return tessellate(outline, pattern::find_node_layout("paper7"),
                      {.edge_length = 0.026, .control = control});
}

TEST(TessellateControl, ProgressEndsWhenAllStepsAreDone) {
    Listener listener;
    tile(outlines::read_outline(outlines::example_outline("specimen.svg")), listener.control());
    EXPECT_EQ(listener.started_, 1);
    EXPECT_EQ(listener.finished_, 1);
    EXPECT_EQ(listener.done_, listener.total_);
}

TEST(TessellateControl, StopsAtWhateverStepItIsAsked) {
    const outlines::Outline outline = outlines::read_outline(outlines::example_outline("specimen.svg"));
    Listener all;
    tile(outline, all.control());
    for (std::size_t share = 0; share < 8; ++share) {
        Listener listener(share * 60);  // of some 900 updates
        EXPECT_THROW(tile(outline, listener.control()), base::Stopped) << share;
        EXPECT_EQ(listener.finished_, 1) << "the progress line is ended";
    }
}

TEST(TessellateControl, StopsAtAnyLook) {
    geometry::Polygon hole;
    for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0})
        hole.push_back({0.06 + 0.01 * std::cos(angle), 0.05 + 0.01 * std::sin(angle)});
    const outlines::Outline outline =
        outlines::make_outline({{0, 0}, {0.12, 0}, {0.12, 0.1}, {0, 0.1}}, {hole});
    test::expect_stops_at_any_look(
        [&](const base::Control& control) {
            tessellate(outline, pattern::find_node_layout("paper7"),
                       {.edge_length = 0.02, .threads = 1, .control = control});
        },
        [] {});
}

TEST(TessellateControl, AStopBeforeTheBeginIsSeen) {
    std::stop_source source;
    source.request_stop();
    EXPECT_THROW(tile(outlines::make_outline({{0, 0}, {1, 0}, {1, 1}}, {}), {.stop = source.get_token()}),
                 base::Stopped);
}

}  // namespace THIS_TEST
}  // namespace fretwork::tiling

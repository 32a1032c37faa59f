// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/input_file.hpp"
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"

#include <fretwork/library/library.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/tiling/painting/field.hpp>

#include <algorithm>

namespace fretwork::fuzz {
namespace {

constexpr std::size_t kPatternsLookedAt = 4;

const std::vector<geometry::Point2> kPoints = {{0.0, 0.0}, {0.5, 0.5}, {1.0, 0.25}};
constexpr geometry::Box kBox{0.0, 0.0, 1.0, 1.0};

/// Two patterns, of which one has properties.
library::Library asked_library() {
    const std::filesystem::path path = input_file("asked.db", "");
    std::filesystem::remove(path);
    const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    const std::vector<pattern::Pattern> patterns = {pattern::parse_pattern_id(layout, "0-1+1-6"),
                                                    pattern::parse_pattern_id(layout, "0-6")};
    auto library = library::Library::open_or_create(path, layout, reduction::paper_setting(), patterns);
    const library::PatternData data{
        "0-6", {}, {}, {{"bending_stiffness", 0.1}, {"bending_poisson", -0.2}, {"mass_per_area", 0.5}}};
    library.store({&data, 1});
    return library;
}

}  // namespace

/// What comes out of a deck is a frame, as those in files of our own are.
void read_deck(std::string_view bytes) {
    promise_round_trip(
        mechanics::frame_text(mechanics::parse_calculix(bytes, "input").frame),
        [](std::string_view text) { return mechanics::parse_frame(text, "frame"); }, mechanics::frame_text);
}

void read_image(std::string_view bytes) {
    const auto values = tiling::image_values(input_file("input.png", bytes), kBox, kPoints);
    promise(std::ranges::all_of(values, [](double value) { return value >= 0.0 && value <= 1.0; }),
            "a grey is from 0 to 1", "");
}

/// All that a library is asked for.
void read_library(std::string_view bytes) {
    const library::Library library = library::Library::open(input_file("input.db", bytes));
    (void)library.summaries();
    (void)library.failures();
    (void)library.content_hash();
    const auto patterns = library.patterns();
    for (std::size_t i = 0; i < std::min(patterns.size(), kPatternsLookedAt); ++i) {
        (void)library.responses(patterns[i].id);
        (void)library.calibrations(patterns[i].id);
        (void)library.properties(patterns[i].id);
    }
}

/// The field of `paint --patterns field:EXPRESSION`, and the goals of targets.
void read_expression(std::string_view bytes) {
    (void)tiling::expression_values(std::string(bytes), kBox, kPoints);
}

/// The question of `library find --where`, put to a library of one layout.
void read_query(std::string_view bytes) {
    static const library::Library kLibrary = asked_library();
    (void)kLibrary.find({.where = std::string(bytes), .sort = {}});
}

}  // namespace fretwork::fuzz

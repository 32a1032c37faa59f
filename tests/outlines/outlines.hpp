// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the tests of outlines.
#pragma once

#include "support.hpp"

#include <fretwork/outlines/outline.hpp>

#include <algorithm>

namespace fretwork::outlines {

inline std::filesystem::path data_file(const std::string& name) {
    return std::filesystem::path(FRETWORK_SOURCE_DIR) / "tests/outlines/data" / name;
}

inline std::filesystem::path example_outline(const std::string& name) {
    return std::filesystem::path(FRETWORK_SOURCE_DIR) / "experiments/outlines" / name;
}

/// The complaint about a file with this name and content. It begins with the file.
inline std::string refuse_file(const std::string& name, const std::string& content) {
    const test::TemporaryFolder folder;
    const auto path = folder.file(name, content);
    std::string message = test::complaint_of([&] { read_outline(path); });
    EXPECT_THAT(message, testing::HasSubstr(name + ": "));
    return message;
}

/// The lower left and the upper right corner of a polygon's box.
inline std::array<geometry::Point2, 2> box_of(const geometry::Polygon& polygon) {
    std::array<geometry::Point2, 2> box = {polygon.front(), polygon.front()};
    for (const geometry::Point2& p : polygon) {
        box[0] = {std::min(box[0].x, p.x), std::min(box[0].y, p.y)};
        box[1] = {std::max(box[1].x, p.x), std::max(box[1].y, p.y)};
    }
    return box;
}

}  // namespace fretwork::outlines

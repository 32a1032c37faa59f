// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines.hpp"

#include <fretwork/tiling/outline.hpp>

namespace fretwork::tiling {
namespace {

using test::complaint_of;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(OutlineMesh, BorderLoopsAreBoundaryAndHoles) {
    const Outline square = read_outline(data_file("square_with_window.obj"));
    EXPECT_EQ(square.boundary.size(), 12U);
    ASSERT_EQ(square.holes.size(), 1U);
    EXPECT_EQ(square.holes[0].size(), 4U);
    EXPECT_DOUBLE_EQ(area_of(square), 8.0);
}

TEST(OutlineMesh, PlyAndOffAreReadToo) {
    EXPECT_DOUBLE_EQ(area_of(read_outline(data_file("quadrilateral.ply"))), 2.0);
    EXPECT_DOUBLE_EQ(area_of(read_outline(data_file("two_triangles.off"))), 1.0);
}

TEST(OutlineMesh, ComplaintsNameTheFileAndTheVertex) {
    const TemporaryFolder folder;
    const auto refuse = [&](const std::string& content) {
        const auto path = folder.file("o.obj", content);
        const std::string message = complaint_of([&] { read_outline(path); });
        EXPECT_THAT(message, HasSubstr("o.obj"));
        return message;
    };
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\n"), HasSubstr("no face"));
    EXPECT_THAT(refuse("nonsense\n"), HasSubstr("no face"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n"), HasSubstr("vertex 2"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 3 0 0\nv 4 0 0\nv 3 1 0\nf 1 2 3\nf 4 5 6\n"),
                HasSubstr("not one piece"));
    EXPECT_THAT(refuse("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), HasSubstr("touches or crosses"));
}

}  // namespace
}  // namespace fretwork::tiling

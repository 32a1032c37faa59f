// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/sandbox.hpp"

#include <gtest/gtest.h>

namespace fretwork::fuzz {
namespace THIS_TEST {

using base::Json;

TEST(Sandbox, HoldsMessagesThatNameFilesElsewhere) {
    const std::filesystem::path folder = "/tmp/some/files";
    for (const char* member : {"path", "from", "layout"}) {
        EXPECT_FALSE(leaves({{"do", "x"}, {member, "/tmp/some/files/a.json"}}, folder)) << member;
        for (const char* elsewhere :
             {"/etc/passwd", "/tmp/some/files/../a.json", "/tmp/some/files/b/a.json", "a.json"})
            EXPECT_TRUE(leaves({{"do", "x"}, {member, elsewhere}}, folder)) << member << " " << elsewhere;
    }
}

TEST(Sandbox, LetsNamesOfLayoutsThroughAndWhatNamesNoFile) {
    const std::filesystem::path folder = "/tmp/some/files";
    EXPECT_FALSE(leaves({{"do", "open_layout"}, {"from", "paper8"}}, folder));
    EXPECT_FALSE(leaves({{"do", "retile"}, {"layout", "paper8"}}, folder));
    EXPECT_TRUE(leaves({{"do", "open"}, {"path", "paper8"}}, folder)) << "a file in the present folder";
    EXPECT_FALSE(leaves({{"do", "draw_layout"}, {"layout", Json::object()}}, folder));
    EXPECT_FALSE(leaves({{"do", "undo"}}, folder));
    EXPECT_FALSE(leaves(Json("path"), folder));
}

}  // namespace THIS_TEST
}  // namespace fretwork::fuzz

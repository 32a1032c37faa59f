// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"
#include "typed/symmetry_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fretwork::typed {
namespace THIS_TEST {

using design::Symmetry;
using testing::AllOf;
using testing::HasSubstr;

TEST(SymmetryText, ComesBackAsItWasTyped) {
    for (const char* text : {"mirror:x", "mirror:y", "turn:2", "turn:12"})
        EXPECT_EQ(design::symmetry_text(read_symmetry(text)), text);
    EXPECT_EQ(read_symmetry("mirror:x"), (Symmetry{Symmetry::Kind::MirrorX}));
    EXPECT_EQ(read_symmetry("turn:3"), (Symmetry{Symmetry::Kind::Turn, 3}));
}

TEST(SymmetryText, OfAnotherFormIsRefusedWithTheFormsThatThereAre) {
    for (const char* text : {"", "none", "mirror", "mirror:z", "turn:1", "turn:13", "turn:2.5", "turn: 3"}) {
        EXPECT_THAT(test::complaint_of([&] { (void)read_symmetry(text); }),
                    AllOf(HasSubstr("is not a symmetry"), HasSubstr("'" + std::string(text) + "'"),
                          HasSubstr("mirror:x, mirror:y, or turn:N")));
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::typed

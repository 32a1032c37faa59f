// SPDX-License-Identifier: GPL-3.0-or-later
#include "outlines/outlines.hpp"

#include <fretwork/outlines/outline.hpp>

namespace fretwork::outlines {
namespace THIS_TEST {

using test::complaint_of;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

OutlineFile three_squares() {
    OutlineFile file;
    for (const double side : {3.0, 2.0, 1.0})
        file.parts.push_back(
            make_outline({{0, 10 * side}, {side, 10 * side}, {side, 11 * side}, {0, 11 * side}}, {}));
    return file;
}

TEST(TakeParts, TheLargestIsTakenAndTold) {
    const OutlineFile file = take_parts(three_squares(), "largest");
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_DOUBLE_EQ(area_of(file.parts.front()), 9);
    EXPECT_THAT(file.remarks, ElementsAre("part 1 of 3 taken, the largest"));
}

TEST(TakeParts, NumbersCountFromTheLargest) {
    const OutlineFile file = take_parts(three_squares(), "3");
    EXPECT_DOUBLE_EQ(area_of(file.parts.front()), 1);
    EXPECT_THAT(file.remarks, ElementsAre("part 3 of 3 taken"));
}

TEST(TakeParts, AllAreTakenWithoutAWord) {
    EXPECT_EQ(take_parts(three_squares(), "all").parts.size(), 3U);
    EXPECT_THAT(take_parts(three_squares(), "all").remarks, IsEmpty());
}

TEST(TakeParts, AnOnlyPartNeedsNoRemark) {
    OutlineFile file = three_squares();
    file.parts.resize(1);
    EXPECT_THAT(take_parts(file, "largest").remarks, IsEmpty());
    EXPECT_THAT(take_parts(file, "1").remarks, IsEmpty());
}

TEST(TakeParts, OtherWordsAreRefusedWithWhatThereIs) {
    for (const char* word : {"0", "4", "-1", "1.5", "every", ""})
        EXPECT_THAT(complaint_of([&] { take_parts(three_squares(), word); }),
                    AllOf(HasSubstr(word), HasSubstr("1 .. 3")));
}

TEST(SizeText, IsWidthAndHeightInMillimetres) {
    EXPECT_EQ(size_text({make_outline({{0, 0}, {0.284, 0}, {0.284, 0.19}, {0, 0.19}}, {})}), "284 x 190 mm");
    EXPECT_EQ(size_text(three_squares().parts), "3000 x 23000 mm");
}

}  // namespace THIS_TEST
}  // namespace fretwork::outlines

// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of labels of input decks, and how many labels they may have together.
#include "support.hpp"

#include <fretwork/mechanics/decks/detail/label_sets.hpp>

namespace fretwork::mechanics::decks {
namespace THIS_TEST {

using fretwork::test::complaint_of;
using testing::ElementsAre;
using testing::HasSubstr;

LabelSets read(const std::string& text) {
    const InputDeck deck(text, "o.inp");
    LabelSets sets("NSET");
    for (const Card& card : deck.cards()) sets.read(deck, card);
    return sets;
}

TEST(LabelSets, HoldTheLabelsOfRangesAndOfOtherSets) {
    const LabelSets sets = read(
        "*NSET, NSET=RANGES, GENERATE\n1, 10, 4\n3, 3,\n8, 9, \n*NSET, NSET=ALL\n"
        "RANGES, 20, 9\n");
    EXPECT_THAT(*sets.find("RANGES"), ElementsAre(1, 3, 5, 8, 9));
    EXPECT_THAT(*sets.find("ALL"), ElementsAre(1, 3, 5, 8, 9, 20));
    EXPECT_EQ(sets.find("NONE"), nullptr);
}

TEST(LabelSets, ARangeMayReachFarInLargeSteps) {
    const LabelSets sets = read("*NSET, NSET=FAR, GENERATE\n1, 2000000000, 1000000\n");
    EXPECT_EQ(sets.find("FAR")->size(), 2000U);
    EXPECT_EQ(*sets.find("FAR")->rbegin(), 1'999'000'001);
}

TEST(LabelSets, LabelsOfSetsInSetsCountLikeThoseOfRanges) {
    std::string hundred = "A";
    for (int i = 1; i < 100; ++i) hundred += ",A";
    const std::string text = "*NSET, NSET=A, GENERATE\n1, 1000\n*NSET, NSET=B\n" + hundred + "\n";
    EXPECT_EQ(read(text).find("B")->size(), 1000U);
    EXPECT_THAT(complaint_of([&] { read(text + "*NSET, NSET=B, GENERATE\n1, 19900000\n"); }),
                HasSubstr("o.inp: line 6 puts 19900000 labels into a set; with those before, these are "
                          "20001000, where 20000000 at most are understood"));
}

TEST(LabelSets, LabelsOfTheSetsThatLinesNameCountTogether) {
    constexpr std::size_t kLabels = 20'000'000;
    const InputDeck deck("", "o.inp");
    LabelSets sets("ELSET");
    for (std::size_t line = 1; line <= 5; ++line) sets.count_use(deck, line, kLabels);
    EXPECT_THAT(complaint_of([&] { sets.count_use(deck, 6, 1); }),
                HasSubstr("o.inp: line 6 names a set of 1 labels; the deck names sets of 100000001 labels by "
                          "then, where 100000000 at most are understood"));
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::decks

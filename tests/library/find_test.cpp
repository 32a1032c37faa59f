// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Four patterns of masses 1, 2, 3 and 4 kg/m2; the bending stiffness of the last is not known.
class Find : public testing::Test {
  protected:
    Find() : library_(make_library(folder_.path() / "lib.db")), id(ids_of(library_.patterns())) {
        std::vector<PatternData> batch;
        for (std::size_t i = 0; i < id.size(); ++i) {
            const double number = static_cast<double>(i + 1);
            PatternData data = sample_data(id[i], number);
            data.properties = {{"mass_per_area", number}};
            if (i < 3) data.properties.emplace_back("bending_stiffness", 0.1 / number);
            std::ranges::sort(data.properties);
            batch.push_back(data);
        }
        library_.store(batch);
    }

    std::vector<std::string> ids(const PatternQuery& query) const {
        std::vector<std::string> found;
        for (const FoundPattern& pattern : library_.find(query).patterns) found.push_back(pattern.id);
        return found;
    }
    std::string complaint(const PatternQuery& query) const {
        return complaint_of([&] { (void)library_.find(query); });
    }

    TemporaryFolder folder_;
    Library library_;
    std::vector<std::string> id;
};

TEST_F(Find, ComparesAndSorts) {
    EXPECT_THAT(ids({.where = "mass_per_area between 2 and 3", .sort = "mass_per_area", .descending = true}),
                ElementsAre(id[2], id[1]));
    EXPECT_THAT(ids({.sort = "-mass_per_area", .limit = 1}), ElementsAre(id[3]));
    EXPECT_THAT(ids({.where = "edges = 3"}), ElementsAre(id[2]));
    EXPECT_THAT(ids({.where = "bending_stiffness / mass_per_area > 0.02", .sort = "mass_per_area"}),
                ElementsAre(id[0], id[1]));
    EXPECT_THAT(ids({.where = "mass_per_area > 5"}), IsEmpty());
    EXPECT_EQ(ids({.sort = "3"}), ids({})) << "a number is no column";
    EXPECT_EQ(ids({}).size(), 4U);
}

TEST_F(Find, GivesTheValuesBesideTheirColumns) {
    const FoundPatterns found = library_.find({.sort = "mass_per_area"});
    const auto column = [&](const char* name) {
        return std::ranges::find(found.columns, name) - found.columns.begin();
    };
    ASSERT_LT(column("objective"), std::ssize(found.columns));
    EXPECT_EQ(found.patterns[1].values[column("mass_per_area")], 2.0);
    EXPECT_EQ(found.patterns[1].values[column("objective")], 0.5);
    EXPECT_EQ(found.patterns[1].values[column("edges")], 2.0);
    EXPECT_EQ(found.patterns[3].values[column("bending_stiffness")], std::nullopt);
}

/// Unknown values come last, whatever the direction, and fulfil no comparison.
TEST_F(Find, UnknownValuesComeLast) {
    for (const bool descending : {false, true})
        EXPECT_EQ(ids({.sort = "bending_stiffness", .descending = descending}).back(), id[3]);
    EXPECT_EQ(ids({.where = "bending_stiffness > 0"}).size(), 3U);
    EXPECT_THAT(ids({.where = "bending_stiffness is null"}), ElementsAre(id[3]));
}

TEST_F(Find, NamesWhatIsNoExpression) {
    EXPECT_THAT(complaint({.where = "bending_stifness > 0"}), HasSubstr("where: 'bending_stifness > 0'"));
    EXPECT_THAT(complaint({.where = "bending_stifness > 0"}), HasSubstr("no such column"));
    EXPECT_THAT(complaint({.where = "edges = = 2"}), HasSubstr("at '= 2'"));
    EXPECT_THAT(complaint({.where = "\"bending_stifness\" > 0"}), HasSubstr("no such column"));
    EXPECT_THAT(complaint({.where = "edges = max(edges)"}), HasSubstr("where: "));
    EXPECT_THAT(complaint({.where = "edges = ?"}), HasSubstr("parameter"));
    EXPECT_THAT(complaint({.where = "abs(-9223372036854775808) > 0"}), HasSubstr("where: "));
    EXPECT_THAT(complaint({.where = "length(randomblob(1e9)) > 0"}), HasSubstr("where: "));
    EXPECT_THAT(complaint({.sort = "edges desc"}), HasSubstr("sort: "));
    EXPECT_THAT(complaint({.sort = "edges,"}), HasSubstr("sort: "));
    EXPECT_THAT(complaint({.sort = "edges, mass_per_area"}), HasSubstr("sort: "));
    EXPECT_THAT(complaint({.where = "edges = 2; DROP TABLE pattern"}), HasSubstr("where: "));
}

TEST_F(Find, RefusesBracketsThatLeadOutOfTheExpression) {
    const auto names_the_bracket = HasSubstr("at ') ");
    for (const char* trick :
         {"1) LIMIT (1", "1) UNION SELECT pattern_id FROM found WHERE (1", "1) GROUP BY (1"}) {
        EXPECT_THAT(complaint({.where = trick}), AllOf(HasSubstr("where: "), names_the_bracket)) << trick;
        EXPECT_THAT(complaint({.sort = trick}), AllOf(HasSubstr("sort: "), names_the_bracket)) << trick;
    }
    for (const char* sound : {"pattern_id <> ')'", "pattern_id <> ''')'", "((edges)) > (0)",
                              "[edges] > 0 and \"edges\" > `edges` - (1)"})
        EXPECT_EQ(ids({.where = sound}).size(), 4U) << sound;
}

/// A comment would hide the rest of a condition, which would then hold for every pattern.
TEST_F(Find, RefusesCommentsAndSemicolonsOutsideOfQuotes) {
    EXPECT_THAT(complaint({.where = "edges --3 = 6"}),
                AllOf(HasSubstr("at '--3 = 6': -- begins a comment"), HasSubstr("- -3 or -(-3)")));
    EXPECT_THAT(complaint({.sort = "edges -- '(\n) GROUP BY (1"}), HasSubstr("-- begins a comment"));
    EXPECT_THAT(complaint({.where = "edges /* 3 */ > 0"}), HasSubstr("at '/* 3 */ > 0': it begins"));
    EXPECT_THAT(complaint({.where = "edges > 0;"}), HasSubstr("at ';': a semicolon"));
    EXPECT_THAT(complaint({.where = std::string("edges > 0\0", 10)}), HasSubstr("NUL"));
    EXPECT_THAT(ids({.where = "edges - -3 = 6"}), ElementsAre(id[2]));
    EXPECT_THAT(ids({.where = "edges -(-3) = 6"}), ElementsAre(id[2]));
    for (const char* sound : {"pattern_id <> '--'", "pattern_id <> '/*' and edges > 0", "pattern_id <> ';'",
                              "pattern_id <> 'it''s; -- /*'"})
        EXPECT_EQ(ids({.where = sound}).size(), 4U) << sound;
    EXPECT_THAT(complaint({.where = "\"a;b--c\" > 0"}), HasSubstr("no such column: a;b--c"));
}

TEST_F(Find, SaysWhatIsNotClosed) {
    const auto bracket = HasSubstr("at '(': it opens a bracket that is not closed");
    EXPECT_THAT(complaint({.where = "edges = 3 and ("}), bracket);
    EXPECT_THAT(complaint({.where = "(edges) = 3 and ("}), bracket);
    EXPECT_THAT(complaint({.where = "pattern_id = ')' and ("}), bracket);
    EXPECT_THAT(complaint({.where = "pattern_id <> 'a"}), HasSubstr("at ''a': it opens a quote that is not"));
    EXPECT_THAT(complaint({.sort = "[edges"}), HasSubstr("at '[edges': it opens a quote that is not closed"));
    EXPECT_THAT(complaint({.where = "edges ="}), HasSubstr("it is not complete"));
}

/// Brackets and comments do not lead out of the expression, and no other table is read.
TEST_F(Find, ReadsNothingElse) {
    const std::vector<std::string> tricks = {"1) UNION SELECT 1 FROM setting --",
                                             "edges IN (SELECT count(*) FROM provenance)",
                                             "(SELECT json FROM setting) IS NOT NULL",
                                             "load_extension('x')",
                                             "1 -- ",
                                             "1 /*"};
    for (const std::string& trick : tricks) {
        try {
            EXPECT_EQ(library_.find({.where = trick}).columns.front(), "edges") << trick;
        } catch (const base::InputError& error) {
            EXPECT_EQ(error.data().where.at(0).source, "where") << trick;
        }
    }
    EXPECT_THAT(complaint({.where = tricks[1]}), HasSubstr("not authorized"));
    EXPECT_THAT(complaint({.where = tricks[2]}), HasSubstr("prohibited"));
    EXPECT_EQ(library_.pattern_count(), 4U) << "the library can be used as before";
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

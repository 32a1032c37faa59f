// SPDX-License-Identifier: GPL-3.0-or-later
// The queries of the library's page are run, word for word, against a small library.
#include "sample.hpp"

#include <fretwork/base/text.hpp>
#include <fretwork/library/fill.hpp>

#include <sqlite3.h>

#include <algorithm>
#include <map>

namespace fretwork::library {
namespace THIS_TEST {

using namespace test;

using Row = std::map<std::string, std::string>;

std::string readme() {
    return base::read_text_file(FRETWORK_SOURCE_DIR "/docs/guide/library.md");
}

/// The queries of the page, by the heading above each.
std::map<std::string, std::string> queries() {
    std::map<std::string, std::string> result;
    std::string heading;
    bool is_in_query = false;
    for (const std::string& line : base::split(readme(), '\n')) {
        if (line.starts_with("### ")) heading = line.substr(4);
        if (line.starts_with("```")) {
            is_in_query = line == "```sql";
        } else if (is_in_query) {
            result[heading] += line + "\n";
        }
    }
    return result;
}

class LibraryReadme : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = std::make_unique<TemporaryFolder>();
        Library library =
            make_library(path(), {"0-1+1-6", "2-4+2-6", "2-4+4-6", "2-6+4-6", "1-3+3-6",
                                  "0-1+1-2+1-3+1-4+2-5+2-6+4-5", "0-1+1-2+1-3+2-3+2-5+4-5+4-6"});
        FillOptions options;
        options.calibration.starts = 1;
        ASSERT_EQ(fill(library, library.patterns(), options).done, 7U);
    }
    static void TearDownTestSuite() { folder_.reset(); }

    static std::vector<Row> rows_of(const std::string& heading) {
        const auto all = queries();
        if (!all.contains(heading)) throw base::InputError("the page has no query '" + heading + "'");
        sqlite3* handle = nullptr;
        sqlite3_open_v2(path().c_str(), &handle, SQLITE_OPEN_READONLY, nullptr);
        std::vector<Row> rows;
        const auto keep = [](void* target, int columns, char** values, char** names) {
            Row row;
            for (int c = 0; c < columns; ++c) row[names[c]] = values[c] == nullptr ? "null" : values[c];
            static_cast<std::vector<Row>*>(target)->push_back(std::move(row));
            return 0;
        };
        char* complaint = nullptr;
        const int code = sqlite3_exec(handle, all.at(heading).c_str(), keep, &rows, &complaint);
        EXPECT_EQ(code, SQLITE_OK) << heading << ": " << (complaint != nullptr ? complaint : "");
        sqlite3_free(complaint);
        sqlite3_close(handle);
        return rows;
    }

    static double property(const std::string& id, const std::string& name) {
        for (const auto& [present, value] : Library::open(path()).properties(id)) {
            if (present == name) return value;
        }
        throw base::InputError("no property " + name);
    }

    static std::filesystem::path path() { return folder_->path() / "lib.db"; }
    inline static std::unique_ptr<TemporaryFolder> folder_;
};

TEST_F(LibraryReadme, EveryQueryOfThePageHasATest) {
    EXPECT_EQ(queries().size(), 7U);
}

TEST_F(LibraryReadme, StiffestInBendingAreSortedByStiffnessForTheirMass) {
    const auto rows = rows_of("Stiffest in bending");
    ASSERT_EQ(rows.size(), 7U);
    double last = 1e300;
    for (const Row& row : rows) {
        const double stiffness = std::stod(row.at("stiffness_Nm"));
        EXPECT_NEAR(stiffness, property(row.at("pattern_id"), "bending_stiffness"), 1e-12 * stiffness);
        const double ratio = stiffness / property(row.at("pattern_id"), "mass_per_area");
        EXPECT_NEAR(std::stod(row.at("for_its_mass")), ratio, 1e-12 * ratio);
        EXPECT_LE(ratio, last);
        last = ratio;
    }
}

TEST_F(LibraryReadme, SoftestInShearAreStableAndAscend) {
    const auto rows = rows_of("Softest in shear");
    ASSERT_FALSE(rows.empty());
    const Library library = Library::open(path());
    double last = 0.0;
    for (const Row& row : rows) {
        const double stiffness = std::stod(row.at("stiffness_N_per_m"));
        EXPECT_GE(stiffness, last);
        last = stiffness;
        for (const auto& response : library.responses(row.at("pattern_id"))) {
            if (response.scenario != "shear") continue;
            for (const auto& sample : response.samples) EXPECT_TRUE(sample.converged && sample.stable);
        }
    }
}

TEST_F(LibraryReadme, BestCalibratedNamesTheWorstScenario) {
    const auto rows = rows_of("Best calibrated");
    ASSERT_EQ(rows.size(), 7U);
    const Library library = Library::open(path());
    const auto calibrations = library.best_calibrations(rows[0].at("pattern_id"));
    const auto best = std::ranges::find(calibrations, "paper6", &reduction::Calibration::model);
    ASSERT_NE(best, calibrations.end());
    EXPECT_DOUBLE_EQ(std::stod(rows[0].at("objective")), best->objective);
    const auto& errors = best->scenario_errors;
    const auto worst = std::ranges::max_element(errors) - errors.begin();
    EXPECT_EQ(rows[0].at("worst_scenario"),
              library.setting().scenarios[static_cast<std::size_t>(worst)].name);
}

TEST_F(LibraryReadme, MirrorPairsAreMirrorImages) {
    const auto rows = rows_of("Mirror pairs");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].at("id"), "2-4+2-6");
    EXPECT_EQ(rows[0].at("mirror"), "2-4+4-6");
    for (const char* name : {"membrane_stiffness", "bending_stiffness", "membrane_shear", "mass_per_area"}) {
        EXPECT_NEAR(property("2-4+2-6", name), property("2-4+4-6", name), 1e-8 * property("2-4+2-6", name));
    }
}

TEST_F(LibraryReadme, NearestInBehaviourIsSortedAndLeavesThePatternOut) {
    const auto rows = rows_of("Nearest in behaviour to a pattern");
    ASSERT_EQ(rows.size(), 6U);
    double last = 0.0;
    for (const Row& row : rows) {
        EXPECT_NE(row.at("pattern_id"), "0-1+1-6");
        EXPECT_GE(std::stod(row.at("distance")), last);
        last = std::stod(row.at("distance"));
    }
}

TEST_F(LibraryReadme, EquivalentPatternsAreFoundAndMirrorPairsAreNone) {
    const auto rows = rows_of("Equivalent patterns");
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].at("pattern_id"), "0-1+1-2+1-3+1-4+2-5+2-6+4-5");
    EXPECT_EQ(rows[0].at("equivalent"), "0-1+1-2+1-3+2-3+2-5+4-5+4-6");
}

TEST_F(LibraryReadme, SampleStatesAreCountedForEachScenario) {
    const auto rows = rows_of("How far the samples can be trusted");
    ASSERT_EQ(rows.size(), 5U);
    for (const Row& row : rows) {
        EXPECT_EQ(row.at("samples"), "70");
        EXPECT_LE(std::stod(row.at("converged")) + std::stod(row.at("beyond_limit_load")), 1.0);
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::library

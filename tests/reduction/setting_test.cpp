// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>
#include <fretwork/reduction/scenarios/setting_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace fretwork::reduction {
namespace THIS_TEST {

using testing::HasSubstr;

TEST(PaperSetting, IsThatOfSection71) {
    const Setting setting = paper_setting();
    EXPECT_DOUBLE_EQ(2.0 * setting.tile_side, 0.03 * std::sqrt(3.0))
        << "a hexagon's circumradius is its side";
    EXPECT_EQ(setting.material.young_modulus, 1e9);
    EXPECT_EQ(setting.material.poisson_ratio, 0.3);
    EXPECT_DOUBLE_EQ(setting.section.area, 4e-6);
    EXPECT_DOUBLE_EQ(setting.section.I2, 16e-12 / 12.0);
    // Saint-Venant's constant of a square, 0.140577 a^4 (Timoshenko and Goodier, table in 109).
    EXPECT_NEAR(setting.section.J, 0.140577 * 16e-12, 1e-6 * 16e-12);
    EXPECT_EQ(setting.magnitudes, 10);
    EXPECT_EQ(setting.sample_policy, SamplePolicy::Paper);
}

TEST(PaperSetting, IsTheFileOfTheExperiments) {
    const Setting from_file =
        read_setting(std::string(FRETWORK_SOURCE_DIR) + "/experiments/settings/paper.json");
    EXPECT_EQ(setting_difference(from_file, paper_setting()), "");
    EXPECT_EQ(from_file, paper_setting());
}

TEST(MadeSetting, IsThePapersWithStiffJointsAndAFileOfTheExperiments) {
    Setting expected = paper_setting();
    expected.joints = Joints::Stiff;
    EXPECT_EQ(made_setting(), expected);
    EXPECT_EQ(read_setting(std::string(FRETWORK_SOURCE_DIR) + "/experiments/settings/made.json"), expected);
}

TEST(FindSetting, TakesANameOrAFile) {
    EXPECT_EQ(find_setting("paper"), paper_setting());
    EXPECT_EQ(find_setting("made"), made_setting());
    const test::TemporaryFolder folder;
    const auto file = folder.file("plain.json", R"({"format": "fretwork/setting/1", "tile_side": 0.03})");
    EXPECT_EQ(find_setting(file.string()).tile_side, 0.03);
    EXPECT_EQ(find_setting(file.string()).joints, Joints::Centreline) << "a file that does not name them";
    EXPECT_THROW((void)find_setting("built"), base::InputError);
}

TEST(SettingName, IsThatOfAnEqualSetting) {
    EXPECT_EQ(setting_name(paper_setting()), "paper");
    Setting setting = made_setting();
    setting.strength = 4e7;
    EXPECT_EQ(setting_name(setting), "made");
    setting.tile_side *= 2;
    EXPECT_EQ(setting_name(setting), "own");
}

TEST(SettingText, ReadsBackAsTheSameSetting) {
    Setting setting = paper_setting();
    setting.sample_policy = SamplePolicy::Stable;
    setting.divisions = 3;
    setting.tile_side = 0.1 / 3.0;
    setting.material.given_shear_modulus = 3.7e8;
    setting.section.shear_area2 = 3.3e-6;
    setting.scenarios.pop_back();
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip"), setting);
}

TEST(SettingText, NamesJointsOnlyWhereTheyAreStiff) {
    Setting setting = paper_setting();
    const std::string as_before = setting_text(setting);
    EXPECT_THAT(as_before, HasSubstr("fretwork/setting/1"));
    EXPECT_THAT(as_before, testing::Not(HasSubstr("joints")))
        << "libraries and results know settings by this text";
    setting.joints = Joints::Stiff;
    EXPECT_THAT(setting_text(setting), HasSubstr("fretwork/setting/2"));
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip"), setting);
    EXPECT_EQ(setting_difference(setting, paper_setting()),
              "/joints: \"stiff\", where the library has \"centreline\"");
}

TEST(SettingText, KeepsTheStrengthOfTheMaterialInTheSecondFormat) {
    Setting setting = paper_setting();
    EXPECT_THAT(setting_text(setting), HasSubstr("fretwork/setting/1")) << "without a strength, as before";
    setting.strength = 4e7;
    EXPECT_THAT(setting_text(setting), HasSubstr("fretwork/setting/2"));
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip"), setting);
}

TEST(SettingDifference, IsNotMadeByAStrengthForNoResponseDependsOnIt) {
    Setting strong = paper_setting();
    strong.strength = 4e7;
    EXPECT_EQ(setting_difference(strong, paper_setting()), "");
    EXPECT_EQ(setting_text(without_stresses(strong)), setting_text(paper_setting()));
}

TEST(SettingText, KeepsTheShapeOfTheSection) {
    Setting setting = paper_setting();
    setting.section = mechanics::tube_section(0.004, 0.003);
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip"), setting);
    setting.section = mechanics::i_section({0.003, 0.004, 0.0005, 0.0004});
    EXPECT_THAT(setting_text(setting), HasSubstr("fretwork/setting/3"));
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip"), setting);
}

TEST(SettingText, WritesNumbersThatAreNoLongerThoseOfTheShape) {
    Setting setting = paper_setting();
    setting.section = mechanics::circle_section(0.002);
    setting.section.J *= 0.5;
    EXPECT_EQ(parse_setting(setting_text(setting), "round trip").section.J, setting.section.J);
}

TEST(SettingDifference, IsNotMadeByAShapeOfTheSameNumbers) {
    Setting round = paper_setting();
    round.section = mechanics::circle_section(0.002);
    Setting numbers = round;
    numbers.section.shape.reset();
    EXPECT_EQ(setting_difference(round, numbers), "");
}

TEST(SettingDifference, NamesThePlaceAndBothValues) {
    Setting other = paper_setting();
    EXPECT_EQ(setting_difference(other, paper_setting()), "");
    other.section.J = 2.5e-12;
    const std::string difference = setting_difference(other, paper_setting());
    EXPECT_THAT(difference, HasSubstr("/section/J"));
    EXPECT_THAT(difference, HasSubstr("2.5e-12"));
    other = paper_setting();
    other.scenarios.pop_back();
    EXPECT_THAT(setting_difference(other, paper_setting()), HasSubstr("/scenarios"));
    other = paper_setting();
    other.material.given_shear_modulus = 4e8;
    EXPECT_THAT(setting_difference(other, paper_setting()), HasSubstr("/material/shear_modulus"));
}

TEST(SettingDifference, NamesWhatTheLibraryLacks) {
    Setting fewer = paper_setting();
    fewer.scenarios.pop_back();
    const std::string scenario = setting_difference(paper_setting(), fewer);
    EXPECT_THAT(scenario, testing::StartsWith("/scenarios/4: {"));
    EXPECT_THAT(scenario, HasSubstr("saddle"));
    EXPECT_THAT(scenario, testing::EndsWith("}, where the library has nothing"));
    fewer = paper_setting();
    const std::size_t loads = fewer.scenarios[0].loads.size();
    fewer.scenarios[0].loads.pop_back();
    EXPECT_THAT(setting_difference(paper_setting(), fewer),
                testing::StartsWith("/scenarios/0/loads/" + std::to_string(loads - 1) + ": {"));
}

TEST(SettingFile, LeavesOutWhatIsAsInThePaper) {
    const Setting setting = parse_setting(
        R"({"format": "fretwork/setting/1", "section": {"type": "circle", "diameter": 0.003},
            "scenarios": ["dome", {"use": "axial", "max_magnitude": 7}]})",
        "mine.json");
    EXPECT_EQ(setting.tile_side, paper_setting().tile_side);
    EXPECT_EQ(setting.section, mechanics::circle_section(0.003));
    ASSERT_EQ(setting.scenarios.size(), 2U);
    EXPECT_EQ(setting.scenarios[0], paper_scenarios()[3]);
    EXPECT_EQ(setting.scenarios[1].max_magnitude, 7.0);
    EXPECT_EQ(setting.scenarios[1].loads, paper_scenarios()[0].loads);
}

std::string complaint(const std::string& members) {
    try {
        (void)parse_setting(R"({"format": "fretwork/setting/1", )" + members + "}", "mine.json");
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(SettingFile, BadInputIsRefusedByItsPlace) {
    EXPECT_THAT(complaint(R"("tile_sid": 1)"), HasSubstr("tile_side"));
    EXPECT_THAT(complaint(R"("tile_side": -1)"), HasSubstr("/tile_side"));
    EXPECT_THAT(complaint(R"("tile_side": 1e999)"), HasSubstr("mine.json"));
    EXPECT_THAT(complaint(R"("sides": 2)"), HasSubstr("/sides"));
    EXPECT_THAT(complaint(R"("magnitudes": 0)"), HasSubstr("/magnitudes"));
    EXPECT_THAT(complaint(R"("divisions": 0)"), HasSubstr("/divisions"));
    EXPECT_THAT(complaint(R"("branch": "unstable")"), HasSubstr("/branch"));
    EXPECT_THAT(complaint(R"("joints": "rigid")"), HasSubstr("/joints"));
    EXPECT_THAT(complaint(R"("scenarios": [])"), HasSubstr("/scenarios"));
    EXPECT_THAT(complaint(R"("scenarios": ["axail"])"), HasSubstr("axial"));
    EXPECT_THAT(complaint(R"("scenarios": ["axial", "axial"])"), HasSubstr("/scenarios/1"));
    EXPECT_THAT(complaint(R"("sides": 4)"),
                HasSubstr("mine.json: /sides: is 4, where the paper's scenarios need at least 6"));
    EXPECT_THAT(complaint(R"("sides": 4, "scenarios": ["axial"])"),
                HasSubstr("mine.json: /scenarios/0: loads/"));
    EXPECT_THAT(complaint(R"("section": {"type": "rectangle", "width": 0.002})"), HasSubstr("height"));
    EXPECT_THAT(complaint(R"("section": {"type": "tube", "outer_diameter": 1, "inner_diameter": 2})"),
                HasSubstr("/section/inner_diameter"));
    EXPECT_THAT(complaint(R"("material": {"young_modulus": 1e9, "poisson_ratio": 0.7})"),
                HasSubstr("/material/poisson_ratio"));
    EXPECT_THAT(complaint(R"("material": {"young_modulus": 0, "poisson_ratio": 0.3})"),
                HasSubstr("/material/young_modulus"));
    EXPECT_THAT(complaint(R"("material": {"young_modulus": 1e9, "poisson_ratio": 0.3, "strength": 4e7})"),
                HasSubstr("/material/strength: is not a key of fretwork/setting/1"));
    EXPECT_THAT(complaint(R"("tile_side": 1e300)"), HasSubstr("mine.json: /tile_side"));
    EXPECT_THAT(complaint(R"("material": {"young_modulus": 1e308, "poisson_ratio": 0.3})"),
                HasSubstr("1e+18 (Pa)"));
    EXPECT_THAT(complaint(R"("section": {"type": "circle", "diameter": 1e-320})"),
                HasSubstr("mine.json: /section/diameter: is "));
    EXPECT_THAT(complaint(R"("section": {"type": "rectangle", "width": 1e300, "height": 0.002})"),
                HasSubstr("mine.json: /section/width: is 1e+300, where a number from 1e-12 to 1e+12 (m)"));
    // Lengths within their limits, whose moment is not.
    EXPECT_THAT(complaint(R"("section": {"type": "circle", "diameter": 1e-12})"),
                HasSubstr("mine.json: /section: "));
    EXPECT_THAT(complaint(R"("section": {"width": 0.002, "height": 0.002})"),
                HasSubstr("mine.json: /section: the key 'type' is missing"));
    EXPECT_THAT(complaint(R"("scenarios": [{"use": "axial", "max_magnitude": 1e300}])"),
                HasSubstr("/scenarios/0/max_magnitude"));
    EXPECT_THROW((void)read_setting("/nowhere/setting.json"), base::InputError);
}

TEST(Setting, IsValidOnlyIfItsTextCanBeReadBack) {
    const auto refuses = [](auto&& change, const char* place) {
        Setting setting = paper_setting();
        change(setting);
        EXPECT_THAT(test::complaint_of([&] { setting.validate("mine"); }), HasSubstr(place));
        EXPECT_THROW((void)parse_setting(setting_text(setting), "text"), base::InputError) << place;
    };
    refuses([](Setting& s) { s.scenarios[0].loads[0].interface_node = -1; }, "mine: /scenarios/0/loads/0");
    refuses([](Setting& s) { s.scenarios[1].supports[0].interface_node = -1; }, "mine: /scenarios/1/held/0");
    refuses([](Setting& s) { s.scenarios[1].loads[0].force[2] = -1e300; },
            "mine: /scenarios/1/loads/0/force/2");
    refuses([](Setting& s) { s.scenarios[2].weight = 0.0; }, "mine: /scenarios/2/weight");
    refuses([](Setting& s) { s.scenarios[2].weight = -1.0; }, "mine: /scenarios/2/weight");
    refuses([](Setting& s) { s.scenarios[2].name.clear(); }, "mine: /scenarios/2/name");
    refuses([](Setting& s) { s.scenarios[2].loads.clear(); }, "mine: /scenarios/2/loads");
    refuses([](Setting& s) { s.material.poisson_ratio = 0.7; }, "mine: /material/poisson_ratio");
    refuses([](Setting& s) { s.sides = 101; }, "mine: /sides");
    refuses([](Setting& s) { s.divisions = 101; }, "mine: /divisions");
    refuses([](Setting& s) { s.magnitudes = 1001; }, "mine: /magnitudes");
}

TEST(SettingFile, WritingWhatWasReadGivesAnEqualSetting) {
    const test::TemporaryFolder folder;
    Setting setting = paper_setting();
    setting.material.young_modulus = 2.3465e9;
    setting.sample_policy = SamplePolicy::Stable;
    write_setting(setting, folder.path() / "setting.json");
    EXPECT_EQ(read_setting(folder.path() / "setting.json"), setting);
    write_scenario(setting.scenarios[2], folder.path() / "scenario.json");
    EXPECT_EQ(read_scenario(folder.path() / "scenario.json"), setting.scenarios[2]);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction

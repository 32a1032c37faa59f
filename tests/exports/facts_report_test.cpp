// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_sample.hpp"

#include <fretwork/base/json_reader.hpp>
#include <fretwork/exports/making/making_files.hpp>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

FactsOfScene sample_facts() {
    simulation::Surface surface = sample_surface();
    surface.setting.material.density = 1240.0;
    return {fabrication::facts(surface, {}, {}, {.sharp_angle = 3.0}), fabrication::whole_sheet(surface, {})};
}

TEST(FactsReport, TheTableHasUnitsAndTheWarningsTheirPlaces) {
    const std::string text = facts_text(sample_facts().facts);
    EXPECT_THAT(text, AllOf(HasSubstr("length of cut"), HasSubstr(" mm"), HasSubstr(" g "),
                            HasSubstr("tile "), HasSubstr("node ")));
}

TEST(FactsReport, JsonHasTheSameNumbersInSi) {
    const FactsOfScene sample = sample_facts();
    const auto json = base::JsonReader::from_text(facts_json(sample.facts), "facts");
    EXPECT_DOUBLE_EQ(json.at("area").number(), sample.facts.area);
    EXPECT_DOUBLE_EQ(json.at("mass").number(), sample.facts.mass);
    EXPECT_DOUBLE_EQ(json.at("cut_length").number(), sample.facts.cut_length);
    EXPECT_EQ(json.at("warnings").elements().size(), sample.facts.warnings.size());
}

TEST(FactsReport, TheSagIsToldWithTheWeightThatCausesIt) {
    simulation::Surface surface = sample_surface();
    surface.setting.material.density = 1240.0;
    simulation::LoadCase held;
    held.name = "hanging";
    held.supports.push_back({simulation::NodesAtSide{simulation::Side::Left}, mechanics::DofSet::all()});
    const fabrication::Facts facts = fabrication::facts(surface, {}, {&held, nullptr});
    ASSERT_TRUE(facts.sag);
    EXPECT_THAT(facts_text(facts),
                AllOf(HasSubstr(" N on the supports of hanging"), HasSubstr("all beams' times 0.")));
    const auto json = base::JsonReader::from_text(facts_json(facts), "facts");
    EXPECT_DOUBLE_EQ(json.at("sag").at("weight").number(), facts.sag->weight);
}

TEST(FactsReport, ThePageHasACircleForEveryWarningWithAPlace) {
    const FactsOfScene sample = sample_facts();
    ASSERT_FALSE(sample.facts.warnings.empty());
    const std::string page = facts_html(sample);
    EXPECT_THAT(page, AllOf(HasSubstr("<!doctype html>"), HasSubstr("<svg"), HasSubstr("id=\"guides\"")));
    const std::string guides =
        page.substr(page.find("id=\"guides\""), page.find("id=\"labels\"") - page.find("id=\"guides\""));
    std::size_t placed = 0;
    for (const auto& warning : sample.facts.warnings) placed += warning.place ? 1U : 0U;
    std::size_t circles = 0;
    for (std::size_t at = guides.find("<path"); at != std::string::npos; at = guides.find("<path", at + 1))
        ++circles;
    EXPECT_EQ(circles, placed);
}

TEST(FactsReport, CirclesAndNumbersLieOverTheMaterial) {
    const std::string page = facts_html(sample_facts());
    const std::size_t material = page.find("<g id=\"cut\"");
    ASSERT_NE(material, std::string::npos);
    EXPECT_LT(material, page.find("<g id=\"guides\""));
    EXPECT_LT(material, page.find("<g id=\"labels\""));
    EXPECT_EQ(page.find("<g id=\"cut\"", material + 1), std::string::npos);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports

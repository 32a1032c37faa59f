// SPDX-License-Identifier: GPL-3.0-or-later
// Node layouts that are drawn by hand.
#include "running_studio.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <studio/layouts/layout_change.hpp>
#include <studio/layouts/layout_count.hpp>

#include <gmock/gmock.h>

#include <set>
#include <tuple>

namespace fretwork::studio {
namespace THIS_TEST {

using base::Json;
using pattern::find_node_layout;
using pattern::LayoutNodeIndex;
using pattern::NodeLayout;
using pattern::Rational;
using pattern::Region;
using test::Client;
using test::RunningStudio;
using testing::ElementsAre;
using testing::HasSubstr;
using Kind = LayoutChange::Kind;

LayoutChange move(int node, LayoutChange::Place to) {
    return {.kind = Kind::Move, .node = LayoutNodeIndex(node), .to = to};
}
LayoutChange add(Region region, std::optional<LayoutChange::Place> to = {}) {
    return {.kind = Kind::Add, .region = region, .to = to};
}
LayoutChange remove(int node) {
    return {.kind = Kind::Remove, .node = LayoutNodeIndex(node)};
}

TEST(LayoutByHand, ARadialNodeTakesItsPartnerAlong) {
    const NodeLayout layout = find_node_layout("paper7");
    // Nodes 1 and 2 lie on the left side, 3 and 4 on the right one.
    const auto left = changed(layout, move(1, {0.595, 0.405, 0.0}), {.steps = 20});
    EXPECT_THAT(left.layout.description().radial, ElementsAre(Rational(2, 5), Rational(2, 3)));
    EXPECT_EQ(left.node, LayoutNodeIndex(1));
    const auto right = changed(layout, move(3, {0.595, 0.0, 0.405}), {.steps = 20});
    EXPECT_EQ(right.layout.description().radial, left.layout.description().radial);
    EXPECT_THAT(twins_of(layout, LayoutNodeIndex(1)), ElementsAre(LayoutNodeIndex(3)));
}

TEST(LayoutByHand, ANodeOnASideIsNotTakenBeyondItsNeighbours) {
    const NodeLayout layout = find_node_layout("paper7");
    EXPECT_THAT(changed(layout, move(1, {0.0, 1.0, 0.0}), {.steps = 60}).layout.description().radial,
                ElementsAre(Rational(39, 60), Rational(2, 3)));
    EXPECT_THAT(changed(layout, move(1, {2.0, -1.0, 0.0}), {.steps = 60}).layout.description().radial,
                ElementsAre(Rational(1, 60), Rational(2, 3)));
    // Between v1 and the middle this grid has one place, where the node is.
    const NodeLayout doors = find_node_layout("doors6");
    EXPECT_EQ(changed(doors, move(4, {0.0, 1.0, 0.0}), {.steps = 4}).layout.description().interface,
              doors.description().interface);
}

TEST(LayoutByHand, InterfaceNodesStaySymmetricAboutTheMiddle) {
    const NodeLayout doors = find_node_layout("doors6");
    const LayoutChange::Place near_left{0.0, 0.9, 0.1};
    EXPECT_THAT(changed(doors, move(4, near_left), {.steps = 10}).layout.description().interface,
                ElementsAre(Rational(1, 10), Rational(9, 10)));
    EXPECT_THAT(changed(doors, move(5, {0.0, 0.1, 0.9}), {.steps = 10}).layout.description().interface,
                ElementsAre(Rational(1, 10), Rational(9, 10)));
    EXPECT_THAT(changed(doors, move(4, {0.0, 0.1, 0.9}), {.steps = 10}).layout.description().interface,
                ElementsAre(Rational(4, 10), Rational(6, 10)))
        << "not beyond the middle";
    const NodeLayout paper = find_node_layout("paper7");
    EXPECT_EQ(changed(paper, move(6, near_left), {}).layout.description().interface,
              paper.description().interface)
        << "a node in the middle is its own twin";
}

TEST(LayoutByHand, AFaceNodeTakesItsMirrorImageAlongIfThatIsWanted) {
    const NodeLayout layout = find_node_layout("paper8");
    const auto& face = layout.description().face;
    ASSERT_EQ(face.size(), 2U);
    ASSERT_EQ(face[0][1], face[1][2]);
    const LayoutChange change = move(5, {0.5, 0.3, 0.2});
    const auto both = changed(layout, change, {.steps = 10}).layout.description().face;
    EXPECT_THAT(both[0], ElementsAre(Rational(1, 2), Rational(3, 10), Rational(1, 5)));
    EXPECT_THAT(both[1], ElementsAre(Rational(1, 2), Rational(1, 5), Rational(3, 10)));
    const auto one = changed(layout, change, {.steps = 10, .keeps_mirror = false}).layout.description().face;
    EXPECT_EQ(one[0], both[0]);
    EXPECT_EQ(one[1], face[1]);
}

TEST(LayoutByHand, AFaceNodeOnTheAxisStaysThereIfTheMirrorIsKept) {
    const NodeLayout layout = find_node_layout("doors6");
    ASSERT_EQ(layout.nodes()[3].region, Region::Face);
    EXPECT_THAT(changed(layout, move(3, {0.4, 0.4, 0.2}), {.steps = 20}).layout.description().face[0],
                ElementsAre(Rational(2, 5), Rational(3, 10), Rational(3, 10)));
    EXPECT_THAT(changed(layout, move(3, {0.4, 0.4, 0.2}), {.steps = 20, .keeps_mirror = false})
                    .layout.description()
                    .face[0],
                ElementsAre(Rational(2, 5), Rational(2, 5), Rational(1, 5)));
}

TEST(LayoutByHand, WhereverAHandGoesALayoutComesOfItOrAReason) {
    base::SplitMix64 random(1);
    for (const std::string& name : pattern::layout_names()) {
        NodeLayout layout = find_node_layout(name);
        for (int i = 0; i < 200; ++i) {
            const int node = static_cast<int>(random.below(layout.nodes().size()));
            const auto& before = layout.nodes()[LayoutNodeIndex(node)];
            const double x = 1.6 * random.share() - 0.3;
            const double y = 1.6 * random.share() - 0.3;
            try {
                const auto next = changed(layout, move(node, {1.0 - x - y, x, y}),
                                          {.steps = 12, .keeps_mirror = random.below(2) == 0});
                const auto& after = next.layout.nodes()[LayoutNodeIndex(node)];
                EXPECT_EQ(after.region, before.region) << name;
                EXPECT_EQ(next.layout.nodes().size(), layout.nodes().size()) << name;
                if (after.place != before.place) {
                    for (const Rational& coordinate : after.place)
                        EXPECT_EQ(12 % coordinate.denominator(), 0) << name << ": " << coordinate.text();
                }
                layout = next.layout;
            } catch (const base::InputError& error) {
                EXPECT_THAT(error.what(),
                            testing::AnyOf(HasSubstr("already is"), HasSubstr("candidate edges")));
            }
        }
    }
}

TEST(LayoutByHand, WhatIsAddedIsRemovedAgain) {
    const NodeLayout layout = find_node_layout("hollow6");
    for (const Region region : {Region::Center, Region::LeftRadial, Region::Face, Region::Interface}) {
        const auto more = changed(layout, add(region), {});
        ASSERT_TRUE(more.node);
        EXPECT_EQ(more.layout.nodes()[*more.node].region, region);
        EXPECT_GT(more.layout.nodes().size(), layout.nodes().size());
        const auto back = changed(more.layout, remove(more.node->value), {});
        EXPECT_EQ(pattern::node_layout_text(back.layout), pattern::node_layout_text(layout));
    }
}

TEST(LayoutByHand, AddedNodesLieWhereTheyAreWantedWithTheirTwins) {
    const NodeLayout spider = find_node_layout("spider4");
    const auto face = changed(spider, add(Region::Face, LayoutChange::Place{0.5, 0.3, 0.2}), {.steps = 10});
    EXPECT_EQ(face.layout.description().face.size(), spider.description().face.size() + 2);
    EXPECT_THAT(twins_of(face.layout, *face.node), testing::SizeIs(1));
    const auto side =
        changed(spider, add(Region::Interface, LayoutChange::Place{0.0, 0.2, 0.8}), {.steps = 10});
    EXPECT_THAT(side.layout.description().interface,
                ElementsAre(Rational(1, 5), Rational(1, 2), Rational(4, 5)));
    const auto radial =
        changed(spider, add(Region::LeftRadial, LayoutChange::Place{0.1, 0.0, 0.9}), {.steps = 10});
    EXPECT_THAT(radial.layout.description().radial, testing::Contains(Rational(9, 10)));
}

TEST(LayoutByHand, AnAddedInterfaceNodeIsTheOneThatWasPointedAtAndNotItsTwin) {
    // A grid of fifths has no place in the middle, where the share 1/2 goes to 3/5.
    for (const auto& [steps, wanted, share] :
         {std::tuple(std::int64_t{10}, 0.8, Rational(4, 5)),
          std::tuple(std::int64_t{10}, 0.2, Rational(1, 5)), std::tuple(std::int64_t{5}, 0.5, Rational(3, 5)),
          std::tuple(std::int64_t{5}, 0.58, Rational(3, 5)),
          std::tuple(std::int64_t{5}, 0.42, Rational(2, 5))}) {
        const auto more =
            changed(find_node_layout("paper7"),
                    add(Region::Interface, LayoutChange::Place{0.0, 1.0 - wanted, wanted}), {.steps = steps});
        ASSERT_TRUE(more.node);
        EXPECT_EQ(more.layout.nodes()[*more.node].place[2], share) << wanted << " in steps of 1/" << steps;
        EXPECT_EQ(more.layout.description().interface.size(), 3U) << "with its twin";
    }
}

TEST(LayoutByHand, AMirrorImageThatIsThereIsNotAddedAgain) {
    const NodeLayout paper = find_node_layout("paper7");
    const auto both = changed(paper, add(Region::Face, LayoutChange::Place{0.3, 0.25, 0.45}), {.steps = 20});
    EXPECT_EQ(both.layout.description().face, find_node_layout("paper8").description().face);
    const auto axis = changed(paper, add(Region::Face, LayoutChange::Place{0.2, 0.4, 0.4}), {.steps = 20});
    EXPECT_EQ(axis.layout.description().face.size(), 2U) << "its own image";
}

TEST(LayoutByHand, WhatIsNoLayoutIsRefusedWithTheRule) {
    const NodeLayout paper = find_node_layout("paper7");
    const auto why = [&](const LayoutChange& change) -> std::string {
        try {
            (void)changed(paper, change, {.steps = 60});
        } catch (const base::InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(why(remove(6)), HasSubstr("no interface node"));
    EXPECT_THAT(why(add(Region::Center)), HasSubstr("center node already"));
    EXPECT_THAT(why(add(Region::LeftRadial, LayoutChange::Place{2.0 / 3, 1.0 / 3, 0})),
                HasSubstr("no two nodes coincide"));
}

TEST(LayoutCount, FindsAsManyAsTheTableOfLayouts) {
    // experiments/layouts/README.md, which `fretwork enumerate --count` makes.
    const std::pair<const char*, std::uint64_t> table[] = {{"spider4", 11},  {"faces5", 13},
                                                           {"doors6", 188},  {"hollow6", 755},
                                                           {"paper7", 1824}, {"paper8", 13'080}};
    for (const auto& [name, patterns] : table) {
        const CountedPatterns found = counted(find_node_layout(name), {}, {}, {});
        EXPECT_EQ(found.patterns, patterns) << name;
        EXPECT_TRUE(found.is_complete) << name;
    }
}

TEST(LayoutCount, DrawsDifferentValidPatternsAndTheSameOnesAgain) {
    const NodeLayout layout = find_node_layout("paper7");
    const auto filters = pattern::make_filters(layout);
    const CountedPatterns found = counted(layout, {.samples = 30}, {}, {});
    std::set<std::string> ids;
    for (const pattern::Pattern& pattern : found.samples) {
        EXPECT_TRUE(judge(layout, filters, pattern).accepted);
        ids.insert(pattern_id(layout, pattern));
    }
    EXPECT_EQ(ids.size(), 30U);
    EXPECT_EQ(counted(layout, {.samples = 30}, {}, {}).samples, found.samples);
    EXPECT_EQ(counted(find_node_layout("spider4"), {.samples = 30}, {}, {}).samples.size(), 11U)
        << "all there are";
}

TEST(LayoutCount, DrawsEachPatternAlikeOften) {
    // 188 patterns of which 47 are drawn: each by a chance of a quarter. The seed is fixed, so the patterns'
    // numbers are looked at: their mean is 93.5, with a standard deviation of 54.3 sqrt(0.75 / 47) = 6.9.
    const NodeLayout layout = find_node_layout("doors6");
    const auto all = pattern::enumerate_patterns(layout);
    double sum = 0.0;
    const CountedPatterns found = counted(layout, {.samples = 47}, {}, {});
    for (const pattern::Pattern& pattern : found.samples)
        sum += static_cast<double>(std::ranges::find(all, pattern) - all.begin());
    EXPECT_NEAR(sum / 47, 93.5, 4 * 6.9);
}

TEST(LayoutCount, EndsAtItsLimitsAndSaysThatThereAreMore) {
    const NodeLayout layout = find_node_layout("paper7");
    const CountedPatterns some = counted(layout, {.patterns = 100}, {}, {});
    EXPECT_EQ(some.patterns, 100U);
    EXPECT_FALSE(some.is_complete);
    EXPECT_TRUE(counted(layout, {.patterns = 1824}, {}, {}).is_complete) << "exactly as many as there are";
    const CountedPatterns none =
        counted(find_node_layout("fifths12"), {.time = std::chrono::milliseconds(0)}, {}, {});
    EXPECT_FALSE(none.is_complete);
    EXPECT_LT(none.patterns, 6'540'827U);
}

TEST(LayoutCount, StopsWhenItIsAskedTo) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)counted(find_node_layout("fifths12"), {}, {.stop = stop.get_token()}, {}),
                 base::Stopped);
}

// ---- as a page sees it ----

class LayoutPage : public testing::Test {
  protected:
    LayoutPage() : client_(studio_.address()) { client_.hello(); }
    Json opened(const std::string& from) { return client_.ask("open_layout", {{"from", from}}); }
    [[nodiscard]] std::string file() const { return (studio_.folder() / "mine.json").string(); }
    RunningStudio studio_;
    Client client_;
};

TEST_F(LayoutPage, ShowsNodesTwinsAndCandidateEdges) {
    const Json paper = opened("paper7");
    ASSERT_TRUE(paper["ok"].get<bool>()) << paper;
    EXPECT_EQ(paper["layout"]["name"], "my-paper7");
    EXPECT_TRUE(paper["path"].is_null());
    EXPECT_EQ(paper["nodes"].size(), 7U);
    EXPECT_EQ(paper["edges"].size(), 17U);
    EXPECT_EQ(paper["nodes"][1], (Json{{"kind", "radial"},
                                       {"place", {2.0 / 3, 1.0 / 3, 0.0}},
                                       {"exact", {"2/3", "1/3", "0"}},
                                       {"twins", {3}}}));
}

TEST_F(LayoutPage, ChangesAndCountsWhatItIsSent) {
    const Json paper = opened("paper7");
    const Json changed = client_.ask(
        "draw_layout",
        {{"layout", paper["layout"]}, {"change", {{"move", 1}, {"to", {0.5, 0.5, 0.0}}}}, {"grid", 20}});
    ASSERT_TRUE(changed["ok"].get<bool>()) << changed;
    EXPECT_EQ(changed["layout"]["radial"], (Json{"1/2", "2/3"}));
    EXPECT_EQ(changed["node"], 1);
    const Json counted = client_.ask("count_layout", {{"layout", paper["layout"]}, {"key", 1}});
    EXPECT_EQ(counted["patterns"], 1824);
    EXPECT_EQ(counted["complete"], true);
    EXPECT_EQ(counted["samples"].size(), 12U);
    for (const Json& id : counted["samples"])
        EXPECT_NO_THROW((void)parse_pattern_id(pattern::paper_layout(), id.get<std::string>()));
}

TEST_F(LayoutPage, ANewCountEndsTheOneBefore) {
    const Json large = opened("fifths12")["layout"];
    client_.send_text(Json{{"id", 100}, {"do", "count_layout"}, {"layout", large}, {"key", 1}}.dump());
    const Json small = client_.ask("count_layout", {{"layout", opened("spider4")["layout"]}, {"key", 2}});
    EXPECT_EQ(small["patterns"], 11) << small;
}

TEST_F(LayoutPage, ACountSaysWhatItHasFoundByNow) {
    const Json large = opened("fifths12")["layout"];
    client_.send_text(Json{{"id", 100}, {"do", "count_layout"}, {"layout", large}, {"key", 3}}.dump());
    const Json event = client_.event({"layout_count"});
    EXPECT_EQ(event["key"], 3);
    EXPECT_EQ(event["revision"], 0) << "there is no document";
    EXPECT_GT(event["patterns"].get<int>(), 0);
}

TEST_F(LayoutPage, RefusesWhatIsNoChangeOfALayout) {
    const Json layout = opened("paper7")["layout"];
    const auto refusal = [&](const Json& change) {
        const Json answer = client_.ask("draw_layout", {{"layout", layout}, {"change", change}});
        EXPECT_FALSE(answer["ok"].get<bool>()) << change;
        return answer.value("error", "");
    };
    EXPECT_THAT(refusal({{"move", 7}, {"to", {1, 0, 0}}}), HasSubstr("6"));
    EXPECT_THAT(refusal({{"move", 1}}), HasSubstr("to"));
    EXPECT_THAT(refusal({{"move", 1}, {"to", {1, 0}}}), HasSubstr("3"));
    EXPECT_THAT(refusal({{"move", 1}, {"to", {1e9, 0, 0}}}), HasSubstr("barycentric"));
    EXPECT_THAT(refusal({{"add", "corner"}}), HasSubstr("interface"));
    EXPECT_THAT(refusal({{"remove", 6}}), HasSubstr("interface node"));
    EXPECT_FALSE(client_.ask("draw_layout", {{"layout", layout}, {"grid", 1}})["ok"].get<bool>());
    EXPECT_FALSE(opened("no-such-layout")["ok"].get<bool>());
}

TEST_F(LayoutPage, SavesAFileThatIsReadAgain) {
    const Json layout = opened("doors6")["layout"];
    const Json saved = client_.ask("save_layout", {{"layout", layout}, {"path", file()}});
    ASSERT_TRUE(saved["ok"].get<bool>()) << saved;
    EXPECT_EQ(find_node_layout(file()).name(), "my-doors6");
    const Json again = opened(file());
    EXPECT_EQ(again["layout"], layout);
    EXPECT_EQ(again["path"], file());
    EXPECT_EQ(again["hash"], saved["hash"]);
}

TEST_F(LayoutPage, ReadsFilesWithTheLineEndsOfWindows) {
    std::string text = pattern::node_layout_text(find_node_layout("doors6"));
    for (std::size_t end = 0; (end = text.find('\n', end)) != std::string::npos; end += 2)
        text.replace(end, 1, "\r\n");
    base::write_file_atomically(file(), text);
    const Json windows = opened(file());
    ASSERT_TRUE(windows["ok"].get<bool>()) << windows;
    EXPECT_EQ(windows["layout"]["interface"], opened("doors6")["layout"]["interface"]);
    EXPECT_EQ(windows["hash"], base::sha256(text)) << "of the bytes in the file";
    EXPECT_TRUE(
        client_
            .ask("save_layout",
                 {{"layout", windows["layout"]}, {"path", file()}, {"replaces", windows["hash"]}})["ok"]
            .get<bool>());
}

TEST_F(LayoutPage, ReplacesNoFileWithoutAQuestion) {
    const Json layout = opened("doors6")["layout"];
    const Json first = client_.ask("save_layout", {{"layout", layout}, {"path", file()}});
    const auto save = [&](const Json& more) {
        Json request = {{"layout", opened("spider4")["layout"]}, {"path", file()}};
        request.update(more);
        return client_.ask("save_layout", request);
    };
    EXPECT_EQ(save(Json::object())["conflict"]["reason"], "exists");
    EXPECT_TRUE(save({{"replaces", first["hash"]}})["ok"].get<bool>());
    const Json late = save({{"replaces", first["hash"]}});
    EXPECT_EQ(late["conflict"]["reason"], "changed");
    EXPECT_TRUE(save({{"replaces", late["conflict"]["hash"]}})["ok"].get<bool>());

    simulation::write_project(test::studio_project(), file());
    EXPECT_THAT(save({{"replaces", late["conflict"]["hash"]}})["error"].get<std::string>(),
                HasSubstr("is no layout"));
    EXPECT_NO_THROW((void)simulation::read_project(file())) << "a project is not lost";
    EXPECT_THAT(client_.ask("save_layout", {{"layout", layout}, {"path", file() + ".txt"}})["error"]
                    .get<std::string>(),
                HasSubstr(".json"));
}

TEST(LayoutAddress, NamesThePageAndTheLayout) {
    const auto address = [](const std::string& layout) {
        const test::TemporaryFolder folder;
        const Studio studio({.layout = layout, .page = "page.html", .state_folder = folder.path()});
        return studio.address();
    };
    EXPECT_THAT(address("paper8"), testing::EndsWith("&page=layout&layout=paper8"));
    EXPECT_THROW((void)address("no-such-layout"), base::InputError);
    EXPECT_THROW((void)address(""), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::studio

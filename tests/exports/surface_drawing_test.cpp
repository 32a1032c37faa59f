// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"
#include "svg_reading.hpp"

#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>
#include <fretwork/exports/drawings/detail/panels.hpp>
#include <fretwork/exports/drawings/detail/pattern_legend.hpp>
#include <fretwork/exports/drawings/surface_drawing.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::HasSubstr;
using testing::Not;

std::string setup_svg(const simulation::Surface& surface, const simulation::Conditions& conditions) {
    return detail::setup_panel(surface, conditions, {}).document("Setup");
}

/// The lines of a layer without their white edges.
std::vector<pugi::xml_node> coloured_lines(const pugi::xml_node& layer) {
    std::vector<pugi::xml_node> lines;
    for (const pugi::xml_node& path : layer.children("path")) {
        if (path.attribute("stroke").value() != std::string("#ffffff")) lines.push_back(path);
    }
    return lines;
}

class SurfaceDrawing : public testing::Test {
  protected:
    [[nodiscard]] std::vector<DeformedLayer> layers() const {
        return {{"full <&> \"model\"", "#8a8f94", result_lines(surface_, bent(surface_, Rows::EveryNode))},
                {"paper6", "#2166ac", result_lines(surface_, bent(surface_, Rows::InterfaceNodes, 0.9))}};
    }
    simulation::Surface surface_ = sample_surface();
    simulation::Conditions conditions_ = sample_conditions(surface_);
};

TEST_F(SurfaceDrawing, HasATileInItsPatternsColourAndALineForEveryBeam) {
    const Svg svg(surface_svg(surface_));
    const auto tiles = svg.layer("tiles");
    EXPECT_EQ(children(tiles, "polygon"), surface_.tessellation.tiles.size());
    std::size_t tile = 0;
    for (const auto& polygon : tiles.children("polygon")) {
        EXPECT_EQ(polygon.attribute("fill").value(),
                  pattern_colour(surface_.tessellation.tiles[tile++].pattern));
    }
    EXPECT_EQ(lines_of_layer(svg.layer("beams")), simulation::surface_fan(surface_).edges.size());
    for (const pattern::NamedPattern& pattern : surface_.tessellation.patterns)
        EXPECT_THAT(svg.words(), HasSubstr(pattern.id + "\n"));
}

TEST_F(SurfaceDrawing, LongIdsAreBrokenBetweenEdges) {
    surface_.tessellation.patterns[0] =
        pattern::parse_named_pattern(surface_.layout, "0-1+1-2+1-3+1-5+1-6+2-5+3-5+4-5+5-6");
    EXPECT_THAT(Svg(surface_svg(surface_)).words(), HasSubstr("0-1+1-2+1-3+1-5\n+1-6+2-5+3-5+4-5\n+5-6\n"));
}

TEST_F(SurfaceDrawing, IsAtTrueScaleWithBeamsOfTheirWidth) {
    const Svg svg(surface_svg(surface_));
    // Three columns of hexagons: 2 s + 2 * 1.5 s, and half a side of margin on both sides.
    EXPECT_NEAR(svg.width_mm(), 1e3 * kSide * (5.0 + 1.0), 1e-3);
    EXPECT_NEAR(svg.layer("beams").child("path").attribute("stroke-width").as_double(), 2.0, 1e-3);
    EXPECT_THAT(svg.words(), HasSubstr("20 mm")) << "a scale bar of at most a fifth of the width, round";
}

TEST_F(SurfaceDrawing, HasABallForEverySupportAndAnArrowForEveryLoad) {
    for (const std::string& text : {surface_svg(surface_, &conditions_), setup_svg(surface_, conditions_)}) {
        const Svg svg(text);
        EXPECT_EQ(children(svg.layer("supports"), "circle"), 2 * conditions_.supports.size())
            << "ball and its light";
        EXPECT_EQ(children(svg.layer("loads"), "polygon"), conditions_.loads.size());
        EXPECT_THAT(svg.words(), HasSubstr("all components held"));
        EXPECT_THAT(svg.words(), HasSubstr("forces, the largest 1.08 N"));
        EXPECT_THAT(svg.words(), Not(HasSubstr("some components held")))
            << "what is not there is not in the legend";
    }
}

TEST_F(SurfaceDrawing, TheSupportsOfANodeAreOneBall) {
    const mechanics::DofSet rotations{{false, false, false, true, true, true}};
    conditions_.supports = {{mechanics::NodeIndex(0), mechanics::DofSet::translations()},
                            {mechanics::NodeIndex(0), rotations}};
    const Svg svg(surface_svg(surface_, &conditions_));
    EXPECT_EQ(children(svg.layer("supports"), "circle"), 2U) << "ball and its light";
    EXPECT_THAT(svg.words(), HasSubstr("all components held"));
    EXPECT_THAT(svg.words(), Not(HasSubstr("some components held")));
}

TEST_F(SurfaceDrawing, ALoadAlongTheLineOfSightIsARing) {
    conditions_.loads.resize(2);
    conditions_.loads[0].force = {0.0, 0.0, 1.0};
    conditions_.loads[1].force = {0.0, 0.0, -1.0};
    const Svg svg(surface_svg(surface_, &conditions_));
    EXPECT_EQ(children(svg.layer("loads"), "polygon"), 0U);
    EXPECT_EQ(children(svg.layer("loads"), "circle"), 3U) << "two rings, one with a dot";
    EXPECT_EQ(lines_of_layer(svg.layer("loads")), 2U) << "the other with a cross";
}

TEST_F(SurfaceDrawing, ARingTellsTowardsFromAwayInEveryView) {
    conditions_.loads.resize(2);
    conditions_.loads[0].force = {0.0, -1.0, 0.0};  // towards a viewer in front
    conditions_.loads[1].force = {0.0, 1.0, 0.0};
    const ViewOptions from_the_front{.azimuth = 0.0, .elevation = 0.1};
    const Svg svg(detail::setup_panel(surface_, conditions_, from_the_front).document("Setup"));
    EXPECT_EQ(children(svg.layer("loads"), "circle"), 3U) << "two rings, one with a dot";
    EXPECT_EQ(lines_of_layer(svg.layer("loads")), 2U) << "the other with a cross";
    EXPECT_THAT(svg.words(), HasSubstr("towards you"));
}

TEST_F(SurfaceDrawing, AMomentHasTwoHeads) {
    conditions_.loads.resize(1);
    conditions_.loads[0].force.setZero();
    conditions_.loads[0].moment = {0.0, 0.002, 0.0};
    const Svg svg(setup_svg(surface_, conditions_));
    EXPECT_EQ(children(svg.layer("loads"), "polygon"), 2U);
    EXPECT_THAT(svg.words(), HasSubstr("moments, the largest 2 N mm"));
}

TEST_F(SurfaceDrawing, AFewMomentsAreNotLostAmongManyForces) {
    const auto large = sample_surface(8, 6);
    simulation::Conditions many;
    for (std::size_t i = 0; i < large.tessellation.interface_nodes.size(); ++i)
        many.loads.push_back({mechanics::NodeIndex(i), {0.0, 0.0, -1.0}});
    many.loads.front().moment = {0.0, 0.002, 0.0};
    const Svg setup(setup_svg(large, many));
    EXPECT_EQ(children(setup.layer("loads"), "polygon"), 16U + 2U) << "sixteen forces, and a moment's heads";
    EXPECT_THAT(setup.words(), HasSubstr("moments, the largest 2 N mm"));
    EXPECT_THAT(setup.words(), HasSubstr("17 of " + std::to_string(many.loads.size() + 1) + " drawn"));
}

TEST_F(SurfaceDrawing, TheLoadsOfANodeAreOneArrow) {
    conditions_.loads.assign(2, {mechanics::NodeIndex(0), {0.6, 0.0, 0.0}});
    const Svg svg(surface_svg(surface_, &conditions_));
    EXPECT_EQ(children(svg.layer("loads"), "polygon"), 1U);
    EXPECT_THAT(svg.words(), HasSubstr("forces, the largest 1.2 N"));
}

TEST_F(SurfaceDrawing, TheLegendTellsWeightFromForces) {
    conditions_.weights = 1;
    EXPECT_THAT(Svg(surface_svg(surface_, &conditions_)).words(),
                HasSubstr("forces and weight, the largest"));
    conditions_.weights = conditions_.loads.size();
    const std::string words = Svg(setup_svg(surface_, conditions_)).words();
    EXPECT_THAT(words, HasSubstr("weight, the largest 1.08 N"));
    EXPECT_THAT(words, Not(HasSubstr("forces")));
}

TEST_F(SurfaceDrawing, PrescribedDisplacementsAndRotationsAreDiamonds) {
    using mechanics::Dof;
    EXPECT_THAT(setup_svg(surface_, conditions_), Not(HasSubstr("prescribed")));
    conditions_.prescribed = {{mechanics::NodeIndex(0), Dof::uz, -0.004},
                              {mechanics::NodeIndex(0), Dof::ux, 0.001},
                              {mechanics::NodeIndex(1), Dof::ry, 0.5 * std::numbers::pi}};
    for (const std::string& text : {surface_svg(surface_, &conditions_), setup_svg(surface_, conditions_)}) {
        const Svg svg(text);
        EXPECT_EQ(children(svg.layer("prescribed-displacements"), "polygon"), 2U) << "one a node";
        EXPECT_EQ(children(svg.layer("legend-of-conditions"), "polygon"), 2U) << "a diamond and a force";
        EXPECT_THAT(
            svg.words(),
            HasSubstr("prescribed displacements, the largest 4 mm; rotations, the largest 90\xc2\xb0"));
    }
    conditions_.prescribed.erase(conditions_.prescribed.begin(), conditions_.prescribed.begin() + 2);
    EXPECT_THAT(Svg(setup_svg(surface_, conditions_)).words(),
                HasSubstr("prescribed rotations, the largest 90"));
}

TEST_F(SurfaceDrawing, ALongLegendGoesOnInTheNextLine) {
    conditions_.prescribed = {{mechanics::NodeIndex(0), mechanics::Dof::uz, -0.004}};
    conditions_.loads.resize(3);
    conditions_.loads[1].force = {0.0, 0.0, 1.0};
    conditions_.loads[2].force = {0.0, 0.0, -1.0};
    for (mechanics::NodalLoad& load : conditions_.loads) load.moment = 0.1 * load.force;
    const Svg svg(surface_svg(surface_, &conditions_));
    std::set<std::string> lines;
    for (const auto& text : svg.layer("legend-of-conditions").children("text")) {
        const std::string words = text.child_value();
        const double width =
            0.64 * text.attribute("font-size").as_double() * static_cast<double>(words.size());
        EXPECT_LT(text.attribute("x").as_double() + width, svg.width_mm()) << words;
        EXPECT_LT(text.attribute("y").as_double(), svg.height_mm()) << words;
        lines.insert(text.attribute("y").value());
    }
    EXPECT_GT(lines.size(), 1U);
}

TEST_F(SurfaceDrawing, DeformedStatesAreLayersWithTheirColoursAndLabels) {
    const auto drawn = layers();
    const Svg svg(deformed_svg(drawn, {.scale = 1.0, .rest = rim_lines(surface_)}));
    for (const DeformedLayer& layer : drawn) {
        const auto group = svg.layer(identifier_of(layer.label));
        const auto lines = coloured_lines(group);
        ASSERT_EQ(lines.size(), layer.lines.lines.size());
        for (const auto& line : lines) EXPECT_EQ(line.attribute("stroke").value(), layer.colour);
        EXPECT_THAT(svg.words(), HasSubstr(layer.label + ": at most "));
    }
    EXPECT_EQ(lines_of_layer(svg.layer("at-rest")), rim_lines(surface_).lines.size());
    EXPECT_THAT(svg.words(), HasSubstr("displacements at true scale"));
}

TEST_F(SurfaceDrawing, AnotherScaleIsLabelledAndChangesTheSize) {
    DeformedViewOptions options;
    options.scale = 2.5;
    const auto drawn = layers();
    const Svg scaled(deformed_svg(drawn, options));
    EXPECT_THAT(scaled.words(), HasSubstr("displacements 2.5 times as large"));
    EXPECT_NE(scaled.height_mm(), Svg(deformed_svg(drawn)).height_mm());
}

TEST_F(SurfaceDrawing, DisplacementsAreColouredWithALegendUpToTheLargest) {
    const DeformedLayer layer = layers().front();
    const Svg svg(displacement_svg(layer));
    EXPECT_EQ(coloured_lines(svg.layer(identifier_of(layer.label))).size(), layer.lines.lines.size());
    double largest = 0.0;
    for (Eigen::Index i = 0; i < layer.lines.displacements->rows(); ++i)
        largest = std::max(largest, layer.lines.displacements->row(i).head<3>().norm());
    char text[32];
    std::snprintf(text, sizeof text, "%.4g mm\n", 1e3 * largest);
    EXPECT_THAT(svg.words(), HasSubstr(text));
}

TEST_F(SurfaceDrawing, WithoutDisplacementsIsDrawnAtRestInTheFirstColour) {
    const DeformedLayer layer{"rest", "#000000", surface_lines(surface_)};
    const Svg svg(displacement_svg(layer));
    EXPECT_EQ(coloured_lines(svg.layer("rest")).front().attribute("stroke").value(),
              scale_colour(0.5 / 16.0));
}

TEST_F(SurfaceDrawing, LinesNearerToTheViewerAreDrawnOverThoseBehindThemWithAWhiteEdge) {
    // Seen from the front and above, what is higher is nearer.
    DeformedLayer layer{"crossing", "#000000", {}};
    layer.lines.nodes = {{-1, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 1, 0}};
    layer.lines.lines = {{0, 1}, {2, 3}};
    layer.lines.displacements = mechanics::NodeValues::Zero(4, mechanics::kDofsPerNode);
    layer.lines.displacements->row(0)[0] = 1e-3;  // the upper line has another colour
    const Svg svg(displacement_svg(layer));
    const auto lines = coloured_lines(svg.layer("crossing"));
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0].attribute("stroke").value(), scale_colour(0.5 / 16.0));
    EXPECT_EQ(lines[1].attribute("stroke").value(), scale_colour(8.5 / 16.0));
    const auto edge = lines[1].previous_sibling("path");
    EXPECT_STREQ(edge.attribute("stroke").value(), "#ffffff");
    EXPECT_GT(edge.attribute("stroke-width").as_double(), lines[1].attribute("stroke-width").as_double());
}

TEST_F(SurfaceDrawing, TheFirstOfSeveralStatesHidesItsLinesAndNoOtherTearsThem) {
    DeformedLayer layer{"crossing", "#123456", {}};
    layer.lines.nodes = {{-1, 0, 1}, {1, 0, 1}, {0, -1, 0}, {0, 1, 0}};
    layer.lines.lines = {{0, 1}, {2, 3}};
    layer.lines.displacements = mechanics::NodeValues::Zero(4, mechanics::kDofsPerNode);
    DeformedLayer other = layer;
    other.label = "other";
    const Svg svg(deformed_svg(std::vector{layer, other}));
    for (const char* name : {"crossing", "other"}) {
        const auto lines = coloured_lines(svg.layer(name));
        ASSERT_EQ(lines.size(), 2U);
        // The upper one, which runs along x, is drawn last, on its white edge.
        double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
        ASSERT_EQ(std::sscanf(lines[1].attribute("d").value(), "M%lf,%lfL%lf,%lf", &x0, &y0, &x1, &y1), 4);
        EXPECT_GT(std::abs(x1 - x0), std::abs(y1 - y0));
    }
    EXPECT_STREQ(
        coloured_lines(svg.layer("crossing"))[1].previous_sibling("path").attribute("stroke").value(),
        "#ffffff");
    EXPECT_EQ(children(svg.layer("other"), "path"), 2U) << "no white over the first";
}

/// The ends of a path of one line, mm.
std::array<double, 4> ends_of(const pugi::xml_node& path) {
    std::array<double, 4> ends{};
    EXPECT_EQ(
        std::sscanf(path.attribute("d").value(), "M%lf,%lfL%lf,%lf", &ends[0], &ends[1], &ends[2], &ends[3]),
        4);
    return ends;
}

// A fan of lines from one node, and none lies in front of another: no white reaches what is drawn before it.
TEST_F(SurfaceDrawing, NoWhiteEdgeCutsIntoALineThatMeetsItsOwn) {
    for (const double degrees : {10.0, 25.0, 60.0, 90.0, 120.0, 180.0}) {
        const double angle = degrees * std::numbers::pi / 180.0;
        DeformedLayer layer{"joint", "#000000", {}};
        layer.lines.nodes = {{0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0}};
        layer.lines.lines = {{0, 1}, {2, 0}};
        DeformedViewOptions options;
        options.view = {.azimuth = 0.0, .elevation = 0.5 * std::numbers::pi};
        const Svg svg(displacement_svg(layer, options));
        const auto lines = coloured_lines(svg.layer("joint"));
        ASSERT_EQ(lines.size(), 2U);
        const auto edge = lines[1].previous_sibling("path");
        if (std::string(edge.attribute("stroke").value()) != "#ffffff") continue;  // all of it would cut
        const auto drawn = ends_of(lines[0]);
        const auto white = ends_of(edge);
        const Eigen::Vector2d start(drawn[0], drawn[1]);
        const Eigen::Vector2d along = Eigen::Vector2d(drawn[2], drawn[3]) - start;
        const double clear = 0.5 * (edge.attribute("stroke-width").as_double() +
                                    lines[0].attribute("stroke-width").as_double());
        for (const Eigen::Vector2d& end :
             {Eigen::Vector2d(white[0], white[1]), Eigen::Vector2d(white[2], white[3])}) {
            const double share = std::clamp((end - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
            constexpr double kDigits = 0.02;  // mm: what drawings round to, a few times over
            EXPECT_GE((end - start - share * along).norm(), clear - kDigits) << degrees;
        }
    }
}

TEST_F(SurfaceDrawing, EachTileHasOneShapeAndOnePathOfBeamsInLayersOfInkscape) {
    const Svg svg(surface_svg(surface_));
    std::size_t number = 0;
    for (const auto& path : svg.layer("beams").children("path"))
        EXPECT_EQ(path.attribute("id").value(), "beams" + std::to_string(number++));
    EXPECT_EQ(number, surface_.tessellation.tiles.size());
    for (const auto& layer : svg.root().children("g"))
        EXPECT_STREQ(layer.attribute("inkscape:groupmode").value(), "layer");
}

TEST_F(SurfaceDrawing, TheFigureHoldsAllPanels) {
    const auto drawn = layers();
    const Svg svg(figure_svg(surface_, conditions_, drawn));
    EXPECT_EQ(svg.width_mm(), 84.0) << "a column";
    EXPECT_EQ(children(svg.root(), "svg"), 3U);
    // One title of the document, and one of each tile in both panels that show them.
    EXPECT_EQ(svg.count("title"), 1U + 2 * surface_.tessellation.tiles.size());
    EXPECT_EQ(coloured_lines(svg.layer("deformed-paper6")).size(), drawn[1].lines.lines.size());
    EXPECT_EQ(children(svg.layer("setup-supports"), "circle"), 2 * conditions_.supports.size());
}

TEST_F(SurfaceDrawing, TheFigureShowsTheBeamsOfTheReducedModelThatItIsGiven) {
    const auto drawn = layers();
    DeformedViewOptions options;
    options.reduced = surface_lines(surface_);
    const Svg svg(figure_svg(surface_, conditions_, drawn, options));
    EXPECT_EQ(children(svg.root(), "svg"), 4U);
    EXPECT_EQ(lines_of_layer(svg.layer("reduced-beams-of-the-reduced-model")), options.reduced.lines.size());
    EXPECT_EQ(children(svg.layer("reduced-tiles"), "polygon"), surface_.tessellation.tiles.size());
}

/// A surface with so many patterns.
simulation::Surface painted_with(std::size_t count) {
    const auto layout = pattern::find_node_layout("paper7");
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < count; ++i) {
        std::string id = "0-1+1-6";  // with each combination of four more edges
        for (std::size_t bit = 0; bit < 4; ++bit)
            if ((i >> bit & 1U) != 0) id += std::array{"+2-5", "+3-5", "+4-5", "+5-6"}[bit];
        ids.push_back(pattern::pattern_id(layout, pattern::parse_pattern_id(layout, id)));
    }
    simulation::Project project;
    project.tessellation = honeycomb(6, 4, ids);
    return simulation::make_surface(project, nullptr);
}

TEST_F(SurfaceDrawing, EveryTextIsLegibleInAColumn) {
    for (const std::size_t patterns : {std::size_t{3}, std::size_t{16}}) {
        const simulation::Surface surface = painted_with(patterns);
        const simulation::Conditions conditions = sample_conditions(surface);
        const std::vector<DeformedLayer> bends = {
            {"full", "#8a8f94", result_lines(surface, bent(surface, Rows::EveryNode))},
            {"paper6", "#2166ac", result_lines(surface, bent(surface, Rows::InterfaceNodes, 0.9))}};
        DeformedViewOptions options{.rest = rim_lines(surface), .reduced = surface_lines(surface)};
        const std::span<const DeformedLayer> one(bends.data(), 1);
        for (const std::string& text :
             {surface_svg(surface), surface_svg(surface, &conditions), deformed_svg(bends, options),
              displacement_svg(bends[0], options), figure_svg(surface, conditions, bends, options),
              figure_svg(surface, conditions, one)}) {
            const Svg svg(text);
            EXPECT_EQ(svg.root().attribute("data-print-width").as_double(), 84.0);
            EXPECT_GE(svg.smallest_text_in_print(), kLegible);
        }
    }
}

TEST_F(SurfaceDrawing, ManyPatternsHaveLettersAndAListOfTheirIds) {
    const simulation::Surface surface = painted_with(16);
    const Svg svg(surface_svg(surface));
    EXPECT_THAT(svg.words(), HasSubstr("A\nB\nC\n")) << "beside the fans";
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_THAT(svg.words(), HasSubstr(std::string(1, static_cast<char>('A' + i)) + "\n" +
                                           surface.tessellation.patterns[i].id + "\n"));
}

TEST_F(SurfaceDrawing, LoadsOnOneNodeAreAddedUp) {
    conditions_.loads = {{mechanics::NodeIndex(0), {0.0, 1.0, 0.0}},
                         {mechanics::NodeIndex(1), {0.0, 2.0, 0.0}},
                         {mechanics::NodeIndex(0), {0.0, 2.0, 0.0}}};
    const Svg svg(surface_svg(surface_, &conditions_));
    EXPECT_EQ(children(svg.layer("loads"), "polygon"), 2U);
    EXPECT_THAT(svg.words(), HasSubstr("forces, the largest 3 N"));
}

/// The horizontal extent of each text, from where it starts to about where it ends.
TEST_F(SurfaceDrawing, NoTextOfALegendReachesOutOfTheDrawing) {
    const simulation::Surface surface = painted_with(16);
    simulation::Conditions conditions = sample_conditions(surface);
    for (mechanics::NodalLoad& load : conditions.loads) load.moment = {0.0, 0.002, 0.0};
    for (const std::string& text : {surface_svg(surface, &conditions), setup_svg(surface, conditions)}) {
        const Svg svg(text);
        for (const char* layer : {"legend-of-patterns", "legend-of-conditions"})
            for (const auto& words : svg.layer(layer).children("text"))
                EXPECT_LE(
                    words.attribute("x").as_double() +
                        detail::text_width(words.child_value(), words.attribute("font-size").as_double()),
                    svg.width_mm())
                    << words.child_value();
    }
}

TEST(PatternLegend, LettersGoOnBehindZ) {
    EXPECT_EQ(detail::key_letters(0), "A");
    EXPECT_EQ(detail::key_letters(25), "Z");
    EXPECT_EQ(detail::key_letters(26), "AA");
    EXPECT_EQ(detail::key_letters(52), "BA");
}

TEST_F(SurfaceDrawing, OfManyLoadsTheSetupShowsSomeThatAreFarApart) {
    const auto large = sample_surface(8, 6);
    simulation::Conditions many;
    const auto& places = large.tessellation.interface_nodes;
    for (std::size_t i = 0; i < places.size(); ++i)
        many.loads.push_back({mechanics::NodeIndex(i), {0.0, 0.0, -1.0}});
    const Svg setup(setup_svg(large, many));
    EXPECT_EQ(children(setup.layer("loads"), "polygon"), 16U);
    EXPECT_THAT(setup.words(), HasSubstr("16 of " + std::to_string(places.size()) + " drawn"));
    // From above, without a figure around it, every load is there: as a ring with a cross of two lines.
    EXPECT_EQ(children(Svg(surface_svg(large, &many)).layer("loads"), "circle"), places.size());
}

void collect_ids(const pugi::xml_node& node, std::multiset<std::string>& ids) {
    if (const auto id = node.attribute("id")) ids.insert(id.value());
    for (const auto& child : node.children()) collect_ids(child, ids);
}

TEST_F(SurfaceDrawing, EveryIdOfTheFigureIsThereOnce) {
    const auto drawn = layers();
    std::multiset<std::string> ids;
    const Svg svg(figure_svg(surface_, conditions_, drawn));
    collect_ids(svg.root(), ids);
    for (const std::string& id : ids) EXPECT_EQ(ids.count(id), 1U) << id;
    EXPECT_EQ(ids.count("surface-tile0"), 1U);
    EXPECT_EQ(ids.count("setup-tile0"), 1U);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports

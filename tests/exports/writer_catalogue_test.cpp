// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <set>

namespace fretwork::exports {
namespace THIS_TEST {

using namespace test;
using testing::AllOf;
using testing::HasSubstr;

std::vector<Scene> scenes() {
    const simulation::Surface surface = sample_surface();
    const auto conditions = sample_conditions(surface);
    const Scene::LabelledResult full{"full", bent(surface, Rows::EveryNode)};
    const Scene::LabelledResult reduced{"reduced", bent(surface, Rows::InterfaceNodes)};
    std::vector<Scene> scenes = {{surface},
                                 {surface, conditions},
                                 {surface, std::nullopt, {full}},
                                 {surface, std::nullopt, {full, reduced}},
                                 {surface, std::nullopt, {reduced}, 10.0},
                                 {surface, conditions, {full, reduced}}};
    for (Scene& scene : scenes) scene.picture.size = {64, 40};
    return scenes;
}

TEST(WriterCatalogue, EveryWriterWritesEverySceneDeterministically) {
    for (const WriterRow& writer : writer_catalogue()) {
        EXPECT_FALSE(writer.description.empty());
        std::set<std::string> texts;
        for (const Scene& scene : scenes()) {
            const std::string text = writer.write(scene).text;
            EXPECT_EQ(text, writer.write(scene).text);
            EXPECT_GT(text.size(), 500U);
            if (!writer.is_picture() && writer.content != Content::Solid) {
                EXPECT_EQ(text.find("nan"), std::string::npos) << writer.ending;
            }
            texts.insert(text);
        }
        if (!writer.shows_results())
            EXPECT_EQ(texts.size(), 1U) << writer.ending << ": results make no difference";
        else
            EXPECT_GE(texts.size(), writer.is_made() ? 2U : 3U)
                << writer.ending << ": results make a difference";
    }
}

TEST(WriterCatalogue, FilesThatMoveAreThoseThatShowLoadSteps) {
    const simulation::Surface surface = sample_surface();
    Scene at_end{surface, std::nullopt, {{"full", bent(surface, Rows::EveryNode)}}};
    at_end.picture.size = {64, 40};
    Scene in_steps = at_end;
    simulation::SurfaceResult& result = in_steps.results.front().result;
    result.load_steps = {bent(surface, Rows::EveryNode, 0.5).solution, result.solution};
    for (const WriterRow& writer : writer_catalogue()) {
        if (writer.is_made()) continue;
        EXPECT_EQ(writer.write(in_steps).text != writer.write(at_end).text, writer.moves()) << writer.ending;
        EXPECT_EQ(writer.is_picture() && !writer.has_view(), writer.moves()) << writer.ending;
    }
}

TEST(WriterCatalogue, EndingAndContentNameOneWriter) {
    std::set<std::pair<std::string_view, Content>> rows;
    for (const WriterRow& writer : writer_catalogue()) {
        EXPECT_TRUE(rows.insert({writer.ending, writer.content}).second) << writer.ending;
        const std::string file = "file" + std::string(writer.ending);
        EXPECT_EQ(&find_writer(file, parse_content(std::string(content_name(writer.content)))), &writer);
    }
}

TEST(WriterCatalogue, EndingsMeanWhatTheirUsersExpect) {
    for (const auto& [file, content] : std::map<std::string, Content>{{"a.svg", Content::Drawing},
                                                                      {"a.png", Content::Drawing},
                                                                      {"a.html", Content::Drawing},
                                                                      {"a.obj", Content::Centrelines},
                                                                      {"a.ply", Content::Centrelines},
                                                                      {"a.vtu", Content::Centrelines},
                                                                      {"a.dxf", Content::Cut},
                                                                      {"a.stl", Content::Solid},
                                                                      {"a.3mf", Content::Solid}})
        EXPECT_EQ(find_writer(file).content, content) << file;
}

TEST(WriterCatalogue, AContentThatAnEndingCannotHoldListsWhatItHolds) {
    EXPECT_THAT(complaint_of([] { (void)find_writer("a.stl", Content::Drawing); }),
                AllOf(HasSubstr("a.stl"), HasSubstr("drawing"), HasSubstr("solid")));
    EXPECT_THAT(complaint_of([] { (void)parse_content("solids"); }), HasSubstr("solid"));
}

TEST(WriterCatalogue, AnUnknownEndingListsWhatThereIs) {
    const std::string complaint = complaint_of([] { (void)find_writer("drawing.step"); });
    for (const WriterRow& writer : writer_catalogue())
        EXPECT_THAT(complaint, HasSubstr(std::string(writer.ending)));
    EXPECT_THAT(complaint, AllOf(HasSubstr("drawing.step"), HasSubstr(".step")));
    EXPECT_THAT(complaint_of([] { (void)find_writer("drawing"); }), HasSubstr(".svg"));
    EXPECT_THAT(complaint_of([] { (void)find_writer("drawing.vtk"); }), HasSubstr(".vtu"));
}

TEST(WriterCatalogue, AResultOfAnotherSurfaceIsRefused) {
    const Scene scene{
        sample_surface(4, 3), std::nullopt, {{"wrong", bent(sample_surface(), Rows::EveryNode)}}};
    for (const WriterRow& writer : writer_catalogue()) EXPECT_THROW(writer.write(scene), base::InputError);
}

}  // namespace THIS_TEST
}  // namespace fretwork::exports

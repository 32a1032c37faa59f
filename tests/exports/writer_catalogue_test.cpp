// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <set>

namespace fretwork::exports {
namespace {

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
            const std::string text = writer.text(scene);
            EXPECT_EQ(text, writer.text(scene));
            EXPECT_GT(text.size(), 500U);
            if (!writer.is_picture()) {
                EXPECT_EQ(text.find("nan"), std::string::npos) << writer.ending;
            }
            texts.insert(text);
        }
        EXPECT_GE(texts.size(), 3U) << writer.ending << ": results make a difference";
    }
}

TEST(WriterCatalogue, EndingsAreUnique) {
    std::set<std::string_view> endings;
    for (const WriterRow& writer : writer_catalogue()) EXPECT_TRUE(endings.insert(writer.ending).second);
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
    for (const WriterRow& writer : writer_catalogue()) EXPECT_THROW(writer.text(scene), base::InputError);
}

}  // namespace
}  // namespace fretwork::exports

// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/frame/frame.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace fretwork::mechanics {
namespace THIS_TEST {

using testing::HasSubstr;

/// The message with which a frame is refused, or "".
std::string complaint(const Frame& frame) {
    try {
        validate(frame);
    } catch (const base::InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Frame, SupportedFrameIsValid) {
    EXPECT_EQ(complaint(sample::cantilever()), "");
    EXPECT_EQ(complaint(sample::star()), "");
    EXPECT_EQ(complaint(sample::flat_wheel()), "");
}

TEST(Frame, EmptyFramesAreRefused) {
    EXPECT_THAT(complaint(Frame{}), HasSubstr("/nodes"));
    Frame frame = sample::cantilever();
    frame.beams.clear();
    EXPECT_THAT(complaint(frame), HasSubstr("/beams"));
}

TEST(Frame, NumbersThatAreNotFiniteAreNamed) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    Frame frame = sample::cantilever();
    frame.nodes[1].y() = kNan;
    EXPECT_THAT(complaint(frame), HasSubstr("/nodes/1"));
    frame = sample::star();
    frame.loads[0].force.x() = kNan;
    EXPECT_THAT(complaint(frame), HasSubstr("/loads/0/force"));
    frame = sample::star();
    frame.gravity.z() = std::numeric_limits<double>::infinity();
    EXPECT_THAT(complaint(frame), HasSubstr("/gravity"));
    frame = sample::star();
    frame.beams[2].section.J = kNan;
    EXPECT_THAT(complaint(frame), HasSubstr("/beams/2/section/J"));
    frame = sample::star();
    frame.prescribed.push_back({NodeIndex(0), Dof::ux, kNan});
    EXPECT_THAT(complaint(frame), HasSubstr("/prescribed/0/ux"));
}

TEST(Frame, ImpossibleBeamsAreNamed) {
    Frame frame = sample::star();
    frame.nodes.push_back(frame.nodes[0]);
    frame.beams.push_back(sample::beam_between(0, 4));
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/beams/3"), HasSubstr("no length")));
    frame = sample::star();
    frame.beams[1].nodes[1] = NodeIndex(9);
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/beams/1/nodes"), HasSubstr("no node 9")));
    frame = sample::star();
    frame.beams[1].nodes[1] = frame.beams[1].nodes[0];
    EXPECT_THAT(complaint(frame), HasSubstr("both ends are node 0"));
    frame = sample::star();
    frame.beams[0].normal = frame.nodes[1];
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/beams/0"), HasSubstr("normal")));
    frame = sample::star();
    frame.beams[0].divisions = 0;
    EXPECT_THAT(complaint(frame), HasSubstr("/beams/0/divisions"));
    frame.beams[0].divisions = kMostDivisions + 1;
    EXPECT_THAT(complaint(frame), HasSubstr("/beams/0/divisions: is 1001, where a number from 1 to 1000"));
    frame = sample::star();
    frame.beams[0].material.poisson_ratio = 0.6;
    EXPECT_THAT(complaint(frame), HasSubstr("/beams/0/material/poisson_ratio"));
}

TEST(Frame, FloatingPartIsNamedByANode) {
    Frame frame = sample::star();
    frame.nodes.emplace_back(1, 1, 1);
    frame.nodes.emplace_back(1, 2, 1);
    frame.beams.push_back(sample::beam_between(4, 5));
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/nodes/4"), HasSubstr("not held enough")));
}

TEST(Frame, FreeRigidMotionIsNamed) {
    Frame frame = sample::cantilever();
    frame.supports = {{NodeIndex(0), DofSet::translations()}, {NodeIndex(1), DofSet::translations()}};
    EXPECT_THAT(complaint(frame), HasSubstr("turn about (1, 0, 0)"));
    frame.supports = {{NodeIndex(0), {{true, true, false, true, true, true}}}};
    EXPECT_THAT(complaint(frame), HasSubstr("move along (0, 0, 1)"));
}

TEST(Frame, PrescribedDisplacementCountsAsSupport) {
    Frame frame = sample::cantilever();
    frame.supports = {{NodeIndex(0), {{true, true, false, true, true, true}}}};
    frame.prescribed.push_back({NodeIndex(0), Dof::uz, 0.001});
    EXPECT_EQ(complaint(frame), "");
    frame.prescribed.push_back({NodeIndex(0), Dof::uz, 0.002});
    EXPECT_THAT(complaint(frame), HasSubstr("prescribed twice"));
}

TEST(Frame, GravityNeedsTheDensityOfEveryBeam) {
    Frame frame = sample::star();
    frame.beams[1].material.density = 0.0;
    EXPECT_EQ(complaint(frame), "");
    frame.gravity = {0.0, 0.0, -9.81};
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/beams/1"), HasSubstr("density")));
    EXPECT_THROW(assemble(frame), base::InputError);
    frame.beams[1].material.density = 1240.0;
    EXPECT_EQ(complaint(frame), "");
}

TEST(Frame, NodeWithoutBeamMustBeHeld) {
    Frame frame = sample::star();
    frame.nodes.emplace_back(1, 1, 1);
    EXPECT_THAT(complaint(frame), testing::AllOf(HasSubstr("/nodes/4"), HasSubstr("no beam")));
    sample::clamp(frame, 4);
    EXPECT_EQ(complaint(frame), "");
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics

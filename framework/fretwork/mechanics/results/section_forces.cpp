// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/elements/beam_deformation.hpp>
#include <fretwork/mechanics/elements/beam_element.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>
#include <fretwork/mechanics/results/section_forces.hpp>

namespace fretwork::mechanics {

using namespace elements;

namespace {

Eigen::Matrix3d axes_of(Beam beam, const std::array<Eigen::Vector3d, 2>& ends) {
    beam.nodes = {NodeIndex(0), NodeIndex(1)};
    Frame frame;
    frame.nodes = {ends[0], ends[1]};
    return detail::beam_axes(frame, beam);
}

}  // namespace

BeamSection::BeamSection(const Beam& beam, const std::array<Eigen::Vector3d, 2>& ends)
    : length_((ends[1] - ends[0]).norm()),
      axes_(axes_of(beam, ends)),
      section_(beam.section),
      material_(beam.material) {
    stiffness_ = BeamEnergy(beam_stiffness(section_, material_), length_).stiffness();
}

BeamSection::Ends BeamSection::from_gradient(const Deformations& gradient) const {
    SectionForces start{.N = gradient[kElongation], .T = gradient[kTwist]};
    SectionForces end = start;
    // With the rotations t1 and t2 of the ends relative to the chord, bow = (t1 - t2) / 2 and sway = (t1 +
    // t2) / 2.
    start.M2 = -(gradient[kSway2] + gradient[kBow2]) / 2.0;
    start.M3 = -(gradient[kSway3] + gradient[kBow3]) / 2.0;
    end.M2 = (gradient[kSway2] - gradient[kBow2]) / 2.0;
    end.M3 = (gradient[kSway3] - gradient[kBow3]) / 2.0;
    start.V3 = end.V3 = (end.M2 - start.M2) / length_;
    start.V2 = end.V2 = -(end.M3 - start.M3) / length_;
    return {start, end};
}

BeamSection::Ends BeamSection::linear(const Eigen::Vector<double, 6>& start,
                                      const Eigen::Vector<double, 6>& end) const {
    const Eigen::Vector3d chord = axes_.transpose() * (end.head<3>() - start.head<3>());
    const Eigen::Vector3d spin1 = axes_.transpose() * start.tail<3>();
    const Eigen::Vector3d spin2 = axes_.transpose() * end.tail<3>();
    const double chord2 = -chord[2] / length_;  // rotation of the chord about axis 2; chord3: about axis 3
    const double chord3 = chord[1] / length_;
    Deformations d;
    d[kElongation] = chord[0];
    d[kTwist] = spin2[0] - spin1[0];
    d[kBow2] = (spin1[1] - spin2[1]) / 2.0;
    d[kBow3] = (spin1[2] - spin2[2]) / 2.0;
    d[kSway2] = (spin1[1] + spin2[1]) / 2.0 - chord2;
    d[kSway3] = (spin1[2] + spin2[2]) / 2.0 - chord3;
    return from_gradient(stiffness_.cwiseProduct(d));
}

BeamSection::Ends BeamSection::large(const NodeState& start, const NodeState& end) const {
    const std::array<NodeState, 2> states{start, end};
    const BeamVector d = BeamDeformation(axes_, length_, states).values();
    return from_gradient(BeamEnergy(beam_stiffness(section_, material_), length_).evaluate(d).gradient);
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/elements/beam_element.hpp>
#include <fretwork/mechanics/elements/hinged_element.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>

#include <algorithm>

namespace fretwork::mechanics {
namespace {

using elements::BeamElement;

/// The releases at each end of a beam. If both ends release the torsion (or the axial force), only the
/// release at the first end is kept. It has the same effect, and with both the beam could turn (or slide)
/// freely.
std::array<DofSet, 2> released_dofs(const Beam& beam) {
    std::array<DofSet, 2> free;
    for (const Release& release : beam.releases) {
        auto& contains = free[release.end].contains;
        for (std::size_t d = 0; d < kDofsPerNode; ++d) contains[d] = contains[d] || release.free.contains[d];
    }
    for (const std::size_t along : {std::size_t{0}, std::size_t{3}}) {
        if (free[0].contains[along]) free[1].contains[along] = false;
    }
    return free;
}

class Assembler {
  public:
    Assembler(const Frame& frame, const AssemblyOptions& options) : frame_(frame), options_(options) {}

    Assembly run() {
        assembly_.nodes = frame_.nodes;
        assembly_.reported_nodes = static_cast<int>(frame_.nodes.size());
        assembly_.labels = options_.node_labels;
        assembly_.supports = frame_.supports;
        assembly_.prescribed = frame_.prescribed;
        assembly_.elements.reserve(frame_.beams.size());
        loads_.resize(frame_.nodes.size(), NodeLoad::Zero());
        for (const Beam& beam : frame_.beams) {
            options_.control.check();
            add_beam(beam);
        }
        assembly_.has_moments =
            std::ranges::any_of(frame_.loads, [](const NodalLoad& load) { return !load.moment.isZero(0.0); });
        for (const NodalLoad& load : frame_.loads) {
            load_of(load.node).head<3>() += load.force;
            load_of(load.node).tail<3>() += load.moment;
        }
        assembly_.loads.resize(static_cast<Eigen::Index>(loads_.size()), kDofsPerNode);
        for (std::size_t i = 0; i < loads_.size(); ++i)
            assembly_.loads.row(static_cast<Eigen::Index>(i)) = loads_[i].transpose();
        return std::move(assembly_);
    }

  private:
    using NodeLoad = Eigen::Matrix<double, kDofsPerNode, 1>;

    NodeLoad& load_of(NodeIndex node) { return loads_[node]; }

    const Eigen::Vector3d& position(NodeIndex node) const { return assembly_.nodes[node]; }

    NodeIndex add_node(const Eigen::Vector3d& at) {
        assembly_.nodes.push_back(at);
        loads_.push_back(NodeLoad::Zero());
        return NodeIndex(assembly_.nodes.size() - 1);
    }

    void add_beam(const Beam& beam) {
        const Eigen::Matrix3d axes = detail::beam_axes(frame_, beam);
        const Eigen::Vector3d start = position(beam.nodes[0]);
        const Eigen::Vector3d end = position(beam.nodes[1]);
        const std::array<DofSet, 2> free = released_dofs(beam);
        NodeIndex from = beam.nodes[0];
        for (int k = 1; k <= beam.divisions; ++k) {
            const bool last = k == beam.divisions;
            const NodeIndex to =
                last ? beam.nodes[1]
                     : add_node(start + (end - start) * (static_cast<double>(k) / beam.divisions));
            const BeamElement::Geometry geometry{{from, to}, (end - start).norm() / beam.divisions, axes};
            const Hinges hinges =
                add_element(std::make_unique<BeamElement>(geometry, beam.section, beam.material),
                            {k == 1 ? free[0] : DofSet{}, last ? free[1] : DofSet{}});
            add_weight(geometry, beam, hinges);
            from = to;
        }
    }

    /// The node of the hinge at each end; an invalid index for an end without a hinge.
    using Hinges = std::array<NodeIndex, 2>;

    Hinges add_element(std::unique_ptr<const BeamElement> element, const std::array<DofSet, 2>& free) {
        Hinges hinges;
        if (free[0] == DofSet{} && free[1] == DofSet{}) {
            assembly_.elements.push_back(std::move(element));
            return hinges;
        }
        for (std::size_t end = 0; end < 2; ++end) {
            if (free[end] == DofSet{}) continue;
            hinges[end] = add_node(position(element->geometry().nodes[end]));
            Support held{hinges[end], free[end]};
            for (bool& component : held.fixed.contains) component = !component;
            assembly_.supports.push_back(held);
        }
        assembly_.elements.push_back(std::make_unique<elements::HingedElement>(std::move(element), hinges));
        return hinges;
    }

    /// Add the weight of one element of a beam: half of it at each end and, unless gravity is lumped, the
    /// moments that the element would exert if it were clamped at both ends.
    void add_weight(const BeamElement::Geometry& geometry, const Beam& beam, const Hinges& hinges) {
        const Eigen::Vector3d line_load = beam.material.density * beam.section.area * frame_.gravity;
        const double l = geometry.length;
        const Eigen::Vector3d moment = l * l / 12.0 * geometry.axes.col(0).cross(line_load);
        NodeLoad at_end = NodeLoad::Zero();
        at_end.head<3>() = 0.5 * l * line_load;
        for (std::size_t end = 0; end < 2; ++end) {
            if (!options_.lumped_gravity) at_end.tail<3>() = end == 0 ? moment : -moment;
            load_of(geometry.nodes[end]) += at_end;
            if (hinges[end].is_valid()) add_to_hinge(hinges[end], geometry.axes, at_end);
        }
    }

    /// Add a load on a beam's end also to the hinge, because the load does work along the hinge's motions,
    /// too. In this way, a released moment acts through the beam on the other end, and not on the frame's
    /// node. The hinge's motions are in the beam's axes.
    void add_to_hinge(NodeIndex hinge, const Eigen::Matrix3d& axes, const NodeLoad& load) {
        load_of(hinge).head<3>() += axes.transpose() * load.head<3>();
        load_of(hinge).tail<3>() += axes.transpose() * load.tail<3>();
    }

    const Frame& frame_;
    const AssemblyOptions& options_;
    Assembly assembly_;
    std::vector<NodeLoad> loads_;
};

}  // namespace

Assembly assemble(const Frame& frame, const AssemblyOptions& options) {
    detail::check_parts(frame);
    return Assembler(frame, options).run();
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>
#include <fretwork/mechanics/frame/detail/rigid_motion.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <set>

namespace fretwork::mechanics::detail {
namespace {

using base::format_number;
using base::InputError;

std::string text_of(const Eigen::Vector3d& v) {
    return "(" + format_number(v.x()) + ", " + format_number(v.y()) + ", " + format_number(v.z()) + ")";
}

bool are_within(const Eigen::Vector3d& v, const base::Limits& limits) {
    return base::is_within(v.x(), limits) && base::is_within(v.y(), limits) && base::is_within(v.z(), limits);
}

/// A property of a beam that must be above zero.
struct Property {
    const char* key;
    double value;
    const base::Limits& limits;
};

std::optional<PropertyFlaw> first_flaw(std::initializer_list<Property> properties) {
    for (const Property& property : properties) {
        if (!base::is_positive_within(property.value, property.limits))
            return PropertyFlaw{property.key, "is " + format_number(property.value) + ", where " +
                                                  base::positive_range_text(property.limits) + " is needed"};
    }
    return std::nullopt;
}

class FrameCheck {
  public:
    FrameCheck(const Frame& frame, const FrameNames& names) : frame_(frame), names_(names) {}

    void check_parts() const {
        if (frame_.nodes.empty()) fail("/nodes", "a frame needs at least one node");
        if (frame_.beams.empty()) fail("/beams", "a frame needs at least one beam");
        check_nodes();
        for (std::size_t b = 0; b < frame_.beams.size(); ++b) check_beam(b);
        check_supports();
        check_prescribed();
        check_loads();
        check_gravity();
    }

    void check_held() const {
        const auto held = held_dofs(frame_);
        for (const FreeMotion& motion : free_rigid_motions(frame_, held)) {
            const std::string where = node_place(motion.node);
            if (motion.has_beam) {
                fail(where, "the part of the structure at " + name_of(motion.node) +
                                " is not held enough: it can still " + motion.description);
            }
            fail(where,
                 name_of(motion.node) + " has no beam and is not held; remove it or fix its six components");
        }
    }

  private:
    [[noreturn]] void fail(const std::string& place, const std::string& message) const {
        throw InputError(names_.source, place, message);
    }
    [[noreturn]] void fail_vector(const std::string& place, const Eigen::Vector3d& value,
                                  const base::Limits& limits) const {
        fail(place, "is " + text_of(value) + ", where each must be " + base::range_text(limits));
    }
    static std::string place(const char* list, std::size_t i) {
        return "/" + std::string(list) + "/" + std::to_string(i);
    }
    [[nodiscard]] std::string name_of(NodeIndex node) const {
        const int label = names_.node_labels.empty() ? node.value : names_.node_labels[node];
        return "node " + std::to_string(label);
    }
    [[nodiscard]] std::string node_place(NodeIndex node) const {
        return names_.node_labels.empty() ? place("nodes", node) : name_of(node);
    }
    [[nodiscard]] std::string beam_place(std::size_t beam) const {
        return names_.beam_labels.empty() ? place("beams", beam)
                                          : "element " + std::to_string(names_.beam_labels[beam]);
    }
    /// A source with labels is a deck, where nodes name what acts on them.
    [[nodiscard]] std::string prescribed_place(std::size_t i) const {
        if (!names_.node_labels.empty()) return name_of(frame_.prescribed[i].node);
        return place("prescribed", names_.prescribed_entries.empty() ? i : names_.prescribed_entries[i]);
    }
    [[nodiscard]] std::string load_place(std::size_t i) const {
        return names_.node_labels.empty() ? place("loads", i) : name_of(frame_.loads[i].node);
    }

    void check_nodes() const {
        for (std::size_t i = 0; i < frame_.nodes.size(); ++i) {
            if (!are_within(frame_.nodes[i], base::kLengthLimits))
                fail_vector(node_place(NodeIndex(i)), frame_.nodes[i], base::kLengthLimits);
        }
    }

    [[nodiscard]] bool has_node(NodeIndex node) const {
        return node.value >= 0 && node.value < static_cast<std::int32_t>(frame_.nodes.size());
    }

    void require_node(NodeIndex node, const std::string& where) const {
        if (has_node(node)) return;
        fail(where, "there is no node " + std::to_string(node.value) + "; the frame has nodes 0 to " +
                        std::to_string(frame_.nodes.size() - 1));
    }

    // The place of a beam is written out only if a check fails, because a thousand tiles are checked in a
    // second.

    void check_beam(std::size_t index) const {
        const Beam& beam = frame_.beams[index];
        const auto where = [&](const char* name) { return beam_place(index) + name; };
        for (const NodeIndex node : beam.nodes) {
            if (!has_node(node)) require_node(node, where("/nodes"));
        }
        if (beam.nodes[0] == beam.nodes[1]) fail(where("/nodes"), "both ends are " + name_of(beam.nodes[0]));
        if (beam.normal && !beam.normal->allFinite()) fail(where("/normal"), "is not finite");
        try {
            beam_axes(frame_, beam);
        } catch (const base::GeometryError& error) {
            throw base::within(names_.source, beam_place(index), error);
        }
        if (const auto flaw = flaw_of(beam.section)) fail(where("/section/") + flaw->key, flaw->problem);
        if (const auto flaw = flaw_of(beam.material)) fail(where("/material/") + flaw->key, flaw->problem);
        if (beam.divisions < 1 || beam.divisions > kMostDivisions)
            fail(where("/divisions"), "is " + std::to_string(beam.divisions) + ", where a number from 1 to " +
                                          std::to_string(kMostDivisions) + " is needed");
        for (const Release& release : beam.releases) {
            if (release.end != 0 && release.end != 1)
                fail(where("/releases"),
                     "there is no end " + std::to_string(release.end) + "; a beam has the ends 0 and 1");
        }
    }

    void check_supports() const {
        for (std::size_t i = 0; i < frame_.supports.size(); ++i)
            require_node(frame_.supports[i].node, place("supports", i) + "/node");
    }

    void check_prescribed() const {
        std::set<std::pair<int, Dof>> seen;
        for (std::size_t i = 0; i < frame_.prescribed.size(); ++i) {
            const PrescribedDisplacement& given = frame_.prescribed[i];
            require_node(given.node, prescribed_place(i) + "/node");
            const char* name = dof_name(given.dof);
            const base::Limits& limits = given.dof < Dof::rx ? base::kLengthLimits : base::kAngleLimits;
            if (!base::is_within(given.value, limits))
                fail(prescribed_place(i) + "/" + name, "is " + format_number(given.value) + ", where " +
                                                           base::range_text(limits) + " is needed");
            if (!seen.emplace(given.node.value, given.dof).second)
                fail(prescribed_place(i),
                     std::string(name) + " of " + name_of(given.node) + " is prescribed twice");
        }
    }

    void check_loads() const {
        for (std::size_t i = 0; i < frame_.loads.size(); ++i) {
            require_node(frame_.loads[i].node, load_place(i) + "/node");
            const NodalLoad& load = frame_.loads[i];
            if (!are_within(load.force, base::kForceLimits))
                fail_vector(load_place(i) + "/force", load.force, base::kForceLimits);
            if (!are_within(load.moment, base::kMomentLimits))
                fail_vector(load_place(i) + "/moment", load.moment, base::kMomentLimits);
        }
    }

    /// Check that every beam has a density if gravity acts; a beam without density would be weightless
    /// without notice.
    void check_gravity() const {
        if (!are_within(frame_.gravity, base::kAccelerationLimits))
            fail_vector("/gravity", frame_.gravity, base::kAccelerationLimits);
        if (frame_.gravity.isZero(0.0)) return;
        const auto massless = std::ranges::find_if(
            frame_.beams, [](const Beam& beam) { return !(beam.material.density > 0.0); });
        if (massless != frame_.beams.end())
            fail(beam_place(massless - frame_.beams.begin()),
                 "has no density, and gravity acts on the frame: give its material one");
    }

    const Frame& frame_;
    const FrameNames& names_;
};

}  // namespace

std::optional<PropertyFlaw> flaw_of(const Section& section) {
    auto flaw = first_flaw({{"area", section.area, base::kAreaLimits},
                            {"I2", section.I2, base::kSecondMomentLimits},
                            {"I3", section.I3, base::kSecondMomentLimits},
                            {"J", section.J, base::kSecondMomentLimits}});
    if (!flaw && section.shear_area2)
        flaw = first_flaw({{"shear_area2", *section.shear_area2, base::kAreaLimits}});
    if (!flaw && section.shear_area3)
        flaw = first_flaw({{"shear_area3", *section.shear_area3, base::kAreaLimits}});
    return flaw;
}

std::optional<PropertyFlaw> flaw_of(const Material& material) {
    auto flaw = first_flaw({{"young_modulus", material.young_modulus, base::kModulusLimits}});
    if (flaw) return flaw;
    if (!(material.poisson_ratio > -1.0 && material.poisson_ratio <= 0.5))
        return PropertyFlaw{"poisson_ratio", "is " + format_number(material.poisson_ratio) +
                                                 ", where a number above -1 and up to 0.5 is needed"};
    if (material.given_shear_modulus)
        flaw = first_flaw({{"shear_modulus", *material.given_shear_modulus, base::kModulusLimits}});
    if (!flaw && material.density != 0.0 && !base::is_positive_within(material.density, base::kDensityLimits))
        return PropertyFlaw{"density", "is " + format_number(material.density) + ", where 0 or " +
                                           base::positive_range_text(base::kDensityLimits) + " is needed"};
    return flaw;
}

void check_parts(const Frame& frame) {
    const FrameNames names{"frame"};
    FrameCheck(frame, names).check_parts();
}

void check_frame(const Frame& frame, const FrameNames& names) {
    const FrameCheck check(frame, names);
    check.check_parts();
    check.check_held();
}

Eigen::Matrix3d beam_axes(const Frame& frame, const Beam& beam) {
    const Eigen::Vector3d& start = frame.nodes[beam.nodes[0]];
    const Eigen::Vector3d& end = frame.nodes[beam.nodes[1]];
    constexpr double kParallel = 1e-6;
    const double size = std::max(start.lpNorm<Eigen::Infinity>(), end.lpNorm<Eigen::Infinity>());
    const double length = (end - start).norm();
    if (!(length > 1e-12 * size)) {
        throw base::GeometryError("the beam has no length");
    }
    const Eigen::Vector3d axis1 = (end - start) / length;
    Eigen::Vector3d normal = beam.normal.value_or(Eigen::Vector3d::UnitZ());
    if (!beam.normal && axis1.cross(normal).norm() < kParallel) normal = Eigen::Vector3d::UnitY();
    const Eigen::Vector3d across = normal.cross(axis1);
    if (!(across.norm() > kParallel * normal.norm())) {
        throw base::GeometryError("the normal " + text_of(normal) +
                                  " of the beam has no part at right angles to it");
    }
    Eigen::Matrix3d axes;
    axes.col(0) = axis1;
    axes.col(1) = across.normalized();
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

}  // namespace fretwork::mechanics::detail

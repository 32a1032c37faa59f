// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/mechanics/decks/detail/deck_writer.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace fretwork::mechanics::decks {
namespace {

/// The text of a value, with at most twenty characters, because CalculiX crashes on longer fields.
std::string field(double value) {
    constexpr int kLongest = 20;
    char text[40];
    for (int digits = 17, length = kLongest + 1; length > kLongest; --digits)
        length = std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string vector_text(const Eigen::Vector3d& v) {
    return field(v.x()) + "," + field(v.y()) + "," + field(v.z());
}

/// Refuse features that a deck cannot express.
void check_writable(const Frame& frame) {
    for (std::size_t i = 0; i < frame.beams.size(); ++i) {
        const Beam& beam = frame.beams[i];
        const char* has = !beam.releases.empty()                                 ? "releases"
                          : beam.divisions != 1                                  ? "divisions"
                          : beam.section.shear_area2 || beam.section.shear_area3 ? "shear areas"
                          : beam.material.given_shear_modulus ? "a shear modulus of its own"
                                                              : nullptr;
        if (has != nullptr)
            throw base::InputError("/beams/" + std::to_string(i) + " has " + has +
                                   ", which an input deck cannot express");
    }
}

/// The lines of *BEAM SECTION for a circle, or for the rectangle with the section's area and second moments.
/// CalculiX computes the torsion constant itself.
std::string solid_section(const Section& section, std::size_t beam) {
    constexpr double kSame = 1e-6;
    const double height = rectangle_height(section);
    const double width = rectangle_width(section);
    if (std::abs(width * height - section.area) <= kSame * section.area)
        return "RECT\n" + field(height) + "," + field(width);
    const double diameter = std::sqrt(4.0 * section.area / std::numbers::pi);
    const double second_moment = section.area * diameter * diameter / 16.0;
    if (std::abs(section.I2 - second_moment) <= kSame * second_moment &&
        std::abs(section.I3 - second_moment) <= kSame * second_moment)
        return "CIRC\n" + field(diameter) + "," + field(diameter);
    throw base::InputError("/beams/" + std::to_string(beam) +
                           " has a section that is neither a rectangle nor a circle, which CalculiX needs");
}

class Writer {
  public:
    Writer(const Frame& frame, DeckProgram program) : frame_(frame), program_(program) {}

    std::string run() {
        text_ = "*HEADING\n" + std::string(base::kMadeBy) + "\n*NODE, NSET=NALL\n";
        for (std::size_t i = 0; i < frame_.nodes.size(); ++i)
            text_ += std::to_string(i + 1) + "," + vector_text(frame_.nodes[i]) + "\n";
        if (program_ == DeckProgram::Calculix) write_middle_nodes();
        for (std::size_t i = 0; i < frame_.beams.size(); ++i) group_of(frame_.beams[i]).push_back(i);
        for (std::size_t g = 0; g < groups_.size(); ++g) write_group(g);
        text_ += "*ELSET, ELSET=EALL\n";
        for (std::size_t g = 0; g < groups_.size(); ++g) text_ += "BEAMS" + std::to_string(g + 1) + "\n";
        write_supports();
        const bool is_calculix = program_ == DeckProgram::Calculix;
        text_ += is_calculix ? "*STEP, NLGEOM, INC=1000\n*STATIC\n0.1,1.\n" : "*STEP, NLGEOM\n*STATIC\n";
        write_actions();
        if (is_calculix) text_ += "*NODE PRINT, NSET=NALL\nU\n*NODE FILE\nU\n";
        return text_ + "*END STEP\n";
    }

  private:
    void write_middle_nodes() {
        for (std::size_t i = 0; i < frame_.beams.size(); ++i) {
            const auto& [a, b] = frame_.beams[i].nodes;
            const Eigen::Vector3d middle = 0.5 * (frame_.nodes[a] + frame_.nodes[b]);
            text_ += std::to_string(frame_.nodes.size() + i + 1) + "," + vector_text(middle) + "\n";
        }
    }

    /// Beams with the same section, material and normal.
    struct Group {
        const Beam* like;
        std::vector<std::size_t> beams;
    };

    std::vector<std::size_t>& group_of(const Beam& beam) {
        const auto same = [&](const Group& group) {
            return group.like->section == beam.section && group.like->material == beam.material &&
                   normal_of(*group.like) == normal_of(beam);
        };
        const auto found = std::find_if(groups_.begin(), groups_.end(), same);
        return found != groups_.end() ? found->beams : groups_.emplace_back(Group{&beam, {}}).beams;
    }

    [[nodiscard]] Eigen::Vector3d normal_of(const Beam& beam) const {
        return beam.normal ? *beam.normal : Eigen::Vector3d(detail::beam_axes(frame_, beam).col(2));
    }

    void write_group(std::size_t g) {
        const auto& [like, beams] = groups_[g];
        const std::string name = std::to_string(g + 1);
        const bool is_calculix = program_ == DeckProgram::Calculix;
        text_ +=
            std::string("*ELEMENT, TYPE=") + (is_calculix ? "B32R" : "B31") + ", ELSET=BEAMS" + name + "\n";
        for (const std::size_t i : beams)
            text_ += std::to_string(i + 1) + "," + std::to_string(frame_.beams[i].nodes[0].value + 1) + "," +
                     (is_calculix ? std::to_string(frame_.nodes.size() + i + 1) + "," : "") +
                     std::to_string(frame_.beams[i].nodes[1].value + 1) + "\n";
        const Material& material = like->material;
        text_ += "*MATERIAL, NAME=MATERIAL" + name + "\n*ELASTIC\n" + field(material.young_modulus) + "," +
                 field(material.poisson_ratio) + "\n*DENSITY\n" + field(material.density) + "\n";
        const Section& section = like->section;
        if (is_calculix) {
            text_ += "*BEAM SECTION, ELSET=BEAMS" + name + ", MATERIAL=MATERIAL" + name +
                     ", SECTION=" + solid_section(section, beams.front()) + "\n" +
                     vector_text(normal_of(*like)) + "\n";
            return;
        }
        text_ += "*BEAM GENERAL SECTION, SECTION=GENERAL, ELSET=BEAMS" + name + ", MATERIAL=MATERIAL" + name +
                 "\n";
        for (const double value : {section.area, section.I3, 0.0, section.I2}) text_ += field(value) + ",";
        text_ += field(section.J) + "\n" + vector_text(normal_of(*like)) + "\n";
    }

    void write_supports() {
        text_ += "*BOUNDARY\n";
        for (const Support& support : frame_.supports) {
            for (std::size_t d = 0; d < kDofsPerNode; ++d) {
                if (support.fixed.contains[d])
                    text_ += std::to_string(support.node.value + 1) + "," + std::to_string(d + 1) + "\n";
            }
        }
    }

    void write_actions() {
        if (!frame_.prescribed.empty()) text_ += "*BOUNDARY\n";
        for (const PrescribedDisplacement& given : frame_.prescribed) {
            const std::string d = std::to_string(static_cast<int>(given.dof) + 1);
            text_ +=
                std::to_string(given.node.value + 1) + "," + d + "," + d + "," + field(given.value) + "\n";
        }
        if (!frame_.loads.empty()) text_ += "*CLOAD\n";
        for (const NodalLoad& load : frame_.loads) {
            for (int d = 0; d < kDofsPerNode; ++d) {
                const double value = d < 3 ? load.force[d] : load.moment[d - 3];
                if (value != 0.0)
                    text_ += std::to_string(load.node.value + 1) + "," + std::to_string(d + 1) + "," +
                             field(value) + "\n";
            }
        }
        // The length of the direction has no meaning.
        const double magnitude = frame_.gravity.norm();
        if (magnitude > 0.0)
            text_ += "*DLOAD\nEALL,GRAV," + field(magnitude) + "," + vector_text(frame_.gravity / magnitude) +
                     "\n";
    }

    const Frame& frame_;
    DeckProgram program_;
    std::string text_;
    std::vector<Group> groups_;
};

}  // namespace

std::string deck_text(const Frame& frame, DeckProgram program) {
    validate(frame);
    check_writable(frame);
    return Writer(frame, program).run();
}

}  // namespace fretwork::mechanics::decks

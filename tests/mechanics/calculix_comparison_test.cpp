// SPDX-License-Identifier: GPL-3.0-or-later
// The same frame under CalculiX, if it is installed (Debian: calculix-ccx). Its B32R beams are solids with
// square sections: Timoshenko beams of shear factor one with the polar torsion constant, so ours are given
// both. Poisson's ratio is zero, because joints of solids are stiffer otherwise.
#include "sample.hpp"
#include "support.hpp"

#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace fretwork::mechanics {
namespace THIS_TEST {

constexpr double kSide = 0.0005;
constexpr int kElements = 2;  // a beam
constexpr int kLoaded = 3;

/// Three sides of a hexagon in a zigzag, clamped at the first node.
Frame zigzag() {
    Frame frame;
    frame.nodes = {{0, 0, 0}, {0.013, 0, 0}, {0.0195, 0.01125, 0}, {0.0325, 0.01125, 0}};
    for (int i = 0; i < 3; ++i) frame.beams.push_back(sample::beam_between(i, i + 1));
    sample::clamp(frame, 0);
    for (Beam& beam : frame.beams) {
        beam.section = {.area = kSide * kSide,
                        .I2 = std::pow(kSide, 4) / 12.0,
                        .I3 = std::pow(kSide, 4) / 12.0,
                        .J = std::pow(kSide, 4) / 6.0};
        beam.section.shear_area2 = beam.section.shear_area3 = kSide * kSide;
        beam.material = {.young_modulus = 1e9, .poisson_ratio = 0.0};
        beam.normal = Eigen::Vector3d::UnitZ();
        beam.divisions = 2 * kElements;
    }
    frame.loads = {{NodeIndex(kLoaded), {0.0005, -0.0003, 0.002}}};
    return frame;
}

/// CalculiX reads at most twenty characters.
std::string field(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

/// The frame's nodes are 1, 2, ..; those along its beams follow.
std::string deck_of(const Frame& frame) {
    const auto line = [](int label, const Eigen::Vector3d& at) {
        return std::to_string(label) + "," + field(at.x()) + "," + field(at.y()) + "," + field(at.z()) + "\n";
    };
    std::string nodes = "*NODE, NSET=NALL\n";
    std::string elements = "*ELEMENT, TYPE=B32R, ELSET=EALL\n";
    for (std::size_t i = 0; i < frame.nodes.size(); ++i)
        nodes += line(static_cast<int>(i) + 1, frame.nodes[i]);
    int label = static_cast<int>(frame.nodes.size());
    int element = 0;
    for (const Beam& beam : frame.beams) {
        const Eigen::Vector3d& from = frame.nodes[beam.nodes[0]];
        const Eigen::Vector3d& to = frame.nodes[beam.nodes[1]];
        std::vector<int> along{beam.nodes[0].value + 1};
        for (int k = 1; k < 2 * kElements; ++k) {
            nodes += line(++label, from + (to - from) * k / (2.0 * kElements));
            along.push_back(label);
        }
        along.push_back(beam.nodes[1].value + 1);
        for (std::size_t k = 0; k + 2 < along.size(); k += 2)
            elements += std::to_string(++element) + "," + std::to_string(along[k]) + "," +
                        std::to_string(along[k + 1]) + "," + std::to_string(along[k + 2]) + "\n";
    }
    const Eigen::Vector3d& force = frame.loads[0].force;
    return nodes + elements + "*MATERIAL, NAME=M\n*ELASTIC\n1e9,0.\n" +
           "*BEAM SECTION, ELSET=EALL, MATERIAL=M, SECTION=RECT\n0.0005,0.0005\n0.,0.,1.\n" +
           "*BOUNDARY\n1,1,6\n*STEP, NLGEOM, INC=1000\n*STATIC\n0.25,1.\n*CLOAD\n4,1," + field(force.x()) +
           "\n4,2," + field(force.y()) + "\n4,3," + field(force.z()) +
           "\n*NODE PRINT, NSET=NALL\nU\n*END STEP\n";
}

/// The last displacement of the loaded node that a run has printed.
Eigen::Vector3d last_displacement(const std::string& printed) {
    Eigen::Vector3d found = Eigen::Vector3d::Constant(std::nan(""));
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        int label = 0;
        Eigen::Vector3d u;
        if (words >> label >> u.x() >> u.y() >> u.z() && label == kLoaded + 1) found = u;
    }
    return found;
}

TEST(CalculixComparison, BentZigzagMatchesCalculix) {
    if (std::system("command -v ccx > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "CalculiX (ccx) is not installed";
    const Frame frame = zigzag();
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "zigzag.inp") << deck_of(frame);
    const std::string run =
        "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx zigzag > zigzag.log 2>&1";
    ASSERT_EQ(std::system(run.c_str()), 0) << base::read_text_file(folder.path() / "zigzag.log");
    const Eigen::Vector3d theirs = last_displacement(base::read_text_file(folder.path() / "zigzag.dat"));
    const double factors[] = {0.25, 0.5, 0.75, 1.0};
    const Solution solution = follow_load_path(assemble(frame), factors).back();
    ASSERT_TRUE(solution.converged());
    const Eigen::Vector3d ours = solution.displacements.row(kLoaded).head<3>();
    EXPECT_GT(ours.norm(), 0.003);  // a quarter of a beam's length and more
    // The remaining difference comes from CalculiX's elements and its residual of half a percent of the mean
    // force.
    EXPECT_LT((theirs - ours).norm(), 5e-4 * ours.norm()) << theirs.transpose() << " | " << ours.transpose();
}

/// The zigzag as a frame of ours has it: without shear, with Saint-Venant's torsion.
TEST(CalculixComparison, RunsTheDeckThatIsWrittenForIt) {
    if (std::system("command -v ccx > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "CalculiX (ccx) is not installed";
    Frame frame = zigzag();
    for (Beam& beam : frame.beams) {
        beam.section = rectangle_section(kSide, kSide);
        beam.divisions = 1;
    }
    const test::TemporaryFolder folder;
    std::ofstream(folder.path() / "ours.inp") << calculix_text(frame, DeckProgram::Calculix);
    const std::string run =
        "cd '" + folder.path().string() + "' && OMP_NUM_THREADS=1 ccx -i ours > ours.log 2>&1";
    ASSERT_EQ(std::system(run.c_str()), 0) << base::read_text_file(folder.path() / "ours.log");
    const Eigen::Vector3d theirs = last_displacement(base::read_text_file(folder.path() / "ours.dat"));
    const Eigen::Vector3d ours =
        follow_load_path(assemble(frame), std::vector{1.0}).back().displacements.row(kLoaded).head<3>();
    // One of their quadratic elements a beam, and their torsion constant, a sixth larger.
    EXPECT_LT((theirs - ours).norm(), 0.05 * ours.norm()) << theirs.transpose() << " | " << ours.transpose();
    EXPECT_EQ(parse_calculix(calculix_text(frame, DeckProgram::Calculix), "again").frame.beams.size(),
              2 * frame.beams.size());
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics

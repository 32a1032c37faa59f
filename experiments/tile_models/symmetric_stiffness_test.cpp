// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduction/fixtures.hpp"
#include "symmetric_stiffness.hpp"

#include <fretwork/reduction/models/condensed_tile.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <set>

namespace fretwork::tile_models {
namespace {

using namespace reduction;

const geometry::Polygon& hexagon() {
    static const geometry::Polygon polygon = geometry::regular_polygon(6, paper_setting().tile_side);
    return polygon;
}
double apothem() {
    return paper_setting().tile_side * std::sqrt(0.75);
}
constexpr const char* kDenser = "0-1+1-2+1-5+2-6+5-6";
const geometry::Polygon kIrregular = {
    {0.0, 0.0}, {0.03, -0.004}, {0.05, 0.02}, {0.035, 0.045}, {-0.002, 0.03}};

/// Pivots of 10 to 1000 N/m, couplings within 1.
std::vector<double> random_values(std::uint64_t seed) {
    base::RandomStream random(seed, 0);
    std::vector<double> values;
    for (const auto& parameter : SymmetricStiffness::parameters()) {
        const double u = random.uniform();
        values.push_back(parameter.kind == SymmetricStiffness::Kind::Pivot ? 10.0 * std::pow(100.0, u)
                                                                           : 2.0 * u - 1.0);
    }
    return values;
}

/// Shifts, and turns about the origin by one radian, of the middles of the sides.
Eigen::MatrixXd rigid_motions(const geometry::Polygon& polygon) {
    Eigen::MatrixXd motions(6 * polygon.size(), 6);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& a = polygon[i];
        const auto& b = polygon[(i + 1) % polygon.size()];
        const Eigen::Vector3d place((a.x + b.x) / 2, (a.y + b.y) / 2, 0.0);
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
            motions.block<6, 1>(static_cast<Eigen::Index>(6 * i), k) << axis, Eigen::Vector3d::Zero();
            motions.block<6, 1>(static_cast<Eigen::Index>(6 * i), 3 + k) << axis.cross(place), axis;
        }
    }
    return motions;
}

Eigen::MatrixXd condensed(const char* id) {
    const Setting setting = paper_setting();
    return condensed_frame(
        pattern_frame(paper_layout(), paper_pattern(id), hexagon(), {setting.section, setting.material}), 6);
}

TEST(SymmetricStiffness, HasFortyFourParametersOfDifferentNames) {
    const auto& table = SymmetricStiffness::parameters();
    ASSERT_EQ(table.size(), static_cast<std::size_t>(SymmetricStiffness::kParameters));
    std::set<std::string> names;
    for (const auto& parameter : table) names.insert(parameter.name);
    EXPECT_EQ(names.size(), table.size());
}

TEST(SymmetricStiffness, RigidMotionsMeetNoForceInAnyPolygon) {
    for (const geometry::Polygon& polygon : {hexagon(), kIrregular, geometry::regular_polygon(7, 0.02)}) {
        const Eigen::MatrixXd K = SymmetricStiffness(polygon, apothem()).stiffness(random_values(1));
        const Eigen::MatrixXd motions = rigid_motions(polygon);
        EXPECT_LT((K * motions).norm(), 1e-12 * K.norm() * motions.norm()) << polygon.size() << " sides";
    }
}

TEST(SymmetricStiffness, ResistsEveryOtherMotion) {
    for (const geometry::Polygon& polygon : {hexagon(), kIrregular, geometry::regular_polygon(7, 0.02)}) {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            Eigen::MatrixXd K = SymmetricStiffness(polygon, apothem()).stiffness(random_values(seed));
            for (Eigen::Index i = 0; i < K.rows(); ++i) {  // rotations times the size: all entries in N/m
                if (i % 6 < 3) continue;
                K.row(i) /= apothem();
                K.col(i) /= apothem();
            }
            const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
            EXPECT_LT(std::abs(values[5]), 1e-12 * values[values.size() - 1]);
            EXPECT_GT(values[6], 1e-6 * values[values.size() - 1]) << polygon.size() << " sides";
        }
    }
}

TEST(SymmetricStiffness, StaysAsItIsUnderATurnBy60Degrees) {
    const Eigen::MatrixXd K = SymmetricStiffness(hexagon(), apothem()).stiffness(random_values(2));
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(std::numbers::pi / 3.0, Eigen::Vector3d::UnitZ()).matrix();
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(36, 36);
    for (int node = 0; node < 6; ++node) {
        T.block<3, 3>(6 * ((node + 1) % 6), 6 * node) = turn;
        T.block<3, 3>(6 * ((node + 1) % 6) + 3, 6 * node + 3) = turn;
    }
    EXPECT_LT(relative_difference(T * K * T.transpose(), K), 1e-12);
}

/// The parametrization leaves nothing out: the exact stiffness of any pattern has its values.
TEST(SymmetricStiffness, EqualsTheCondensedStiffnessOfAnyPattern) {
    const SymmetricStiffness model(hexagon(), apothem());
    for (const char* id : {"0-1+1-6", "1-6+3-6", "1-3+3-6", kDenser}) {
        const Eigen::MatrixXd K = condensed(id);
        const std::vector<double> values = model.values_of(K);
        EXPECT_LT((model.stiffness(values) - K).norm(), 1e-8 * K.norm()) << id;
    }
}

/// A known stiffness away from the pattern's own: its answers are found again.
TEST(SymmetricStiffness, IsFittedToTheAnswersOfAKnownOne) {
    const Setting setting = paper_setting();
    const auto pattern = paper_pattern(kDenser);
    const auto start = condensed_values(paper_layout(), pattern, setting);
    const auto& table = SymmetricStiffness::parameters();
    std::vector<double> truth = start;
    base::RandomStream random(5, 0);
    for (std::size_t k = 0; k < truth.size(); ++k) {
        const double share = 2.0 * random.uniform() - 1.0;
        const auto& pivots = table[k].pivots;
        if (table[k].kind == SymmetricStiffness::Kind::Pivot) {
            truth[k] *= std::exp(0.5 * share);
        } else {
            truth[k] += 0.1 * share *
                        std::sqrt(start[static_cast<std::size_t>(pivots[0])] /
                                  start[static_cast<std::size_t>(pivots[1])]);
        }
    }
    const Eigen::MatrixXd K = SymmetricStiffness(hexagon(), apothem()).stiffness(truth);
    const auto responses = linear_responses(unit_displacements(K, setting), setting);
    const CalibrationInput input{paper_layout(), pattern, setting, responses};
    const Calibration found =
        calibrate(symmetric_stiffness_model(start), input, {.starts = 1, .budget = 100000});
    const double before =
        Objective(responses, setting).value(unit_displacements(condensed(kDenser), setting));
    EXPECT_LT(found.objective, 1e-4 * before);
}

}  // namespace
}  // namespace fretwork::tile_models

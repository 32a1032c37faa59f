// SPDX-License-Identifier: GPL-3.0-or-later
// Beams beside the solids of experiments/joints: an independent program (CalculiX, C3D15) on the true
// outline.
#include "fixtures.hpp"

#include <fretwork/reduction/effective_properties.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace fretwork::reduction {
namespace THIS_TEST {

using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    return cells;
}

/// The stored rows of bars as wide as the paper's, from the mesh that all patterns have.
std::vector<Row> rows_of_the_papers_bars() {
    std::ifstream file(std::string(FRETWORK_SOURCE_DIR) + "/experiments/joints/rows.csv");
    std::string line;
    std::getline(file, line);
    const auto names = cells_of(line);
    std::vector<Row> rows;
    while (std::getline(file, line)) {
        Row row;
        const auto cells = cells_of(line);
        for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = cells.at(i);
        const bool is_main = row["mesh"] == "0.5" && row["corner"] == "0.5" && row["layers"] == "1" &&
                             std::stod(row["fillet_mm"]) == 0.0;
        if (is_main && std::stod(row["width_mm"]) == 2.0) rows.push_back(row);
    }
    return rows;
}

/// The mean of |log(solid / beams)| over the patterns and both entries, which is about a relative error.
double mean_error(const Setting& setting, const std::array<std::string, 2>& entries) {
    const auto layout = pattern::find_node_layout("paper8");
    double sum = 0.0;
    const auto rows = rows_of_the_papers_bars();
    for (const Row& row : rows) {
        const auto plate =
            effective_properties(layout, pattern::parse_pattern_id(layout, row.at("pattern")), setting);
        for (const std::string& entry : entries) {
            const auto i = static_cast<Eigen::Index>(entry[1] == '1' ? 0 : 2);
            const double beams = entry[0] == 'A' ? plate.A(i, i) : plate.D(i, i);
            sum += std::abs(std::log(std::stod(row.at("solid_" + entry)) / beams));
        }
    }
    return sum / (2.0 * static_cast<double>(rows.size()));
}

// The page has the figures themselves; these bounds leave them some room.
TEST(StiffJoints, CloseMoreThanHalfOfTheGapToSolidsInThePlane) {
    ASSERT_GE(rows_of_the_papers_bars().size(), 60U);
    Setting setting = paper_setting();
    const double centreline = mean_error(setting, {"A11", "A66"});
    setting.joints = Joints::Stiff;
    EXPECT_GT(centreline, 0.2);
    EXPECT_LT(mean_error(setting, {"A11", "A66"}), 0.5 * centreline);
}

TEST(StiffJoints, ComeNearerToSolidsOutOfThePlane) {
    Setting setting = paper_setting();
    const double centreline = mean_error(setting, {"D11", "D66"});
    setting.joints = Joints::Stiff;
    EXPECT_LT(mean_error(setting, {"D11", "D66"}), 0.8 * centreline);
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction

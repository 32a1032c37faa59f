// SPDX-License-Identifier: GPL-3.0-or-later
#include "fixtures.hpp"

#include <fretwork/mechanics/linear_solver.hpp>
#include <fretwork/mechanics/modes.hpp>
#include <fretwork/mechanics/paths/equilibrium.hpp>
#include <fretwork/reduction/calibration/model_response.hpp>
#include <fretwork/reduction/models/corotational_tile.hpp>

#include <gtest/gtest.h>

namespace fretwork::reduction {
namespace THIS_TEST {

constexpr const char* kPatterns[] = {"0-1+1-6", "1-6+3-6"};

mechanics::Assembly tile_of(const std::string& model, const std::string& pattern) {
    const Setting setting = paper_setting();
    const ModelTile tile(find_tile_model(model), paper_layout(), paper_pattern(pattern), setting);
    return assemble(tile.parts({}));
}

mechanics::NodeValues interface_displacements(const mechanics::Assembly& tile) {
    return mechanics::follow_load_path(tile, std::vector{1.0}).back().displacements.topRows(6);
}

/// The paper's scenarios turn nodes by up to half a radian; here they turn by up to a fiftieth of that.
TEST(CorotationalTile, DiffersFromItsFullModelInProportionToTheLoad) {
    Setting setting = paper_setting();
    for (Scenario& scenario : setting.scenarios) scenario.max_magnitude *= 0.02;
    setting.magnitudes = 2;
    for (const char* pattern : kPatterns) {
        const auto responses = [&](const std::string& model) {
            return ModelTile(find_tile_model(model), paper_layout(), paper_pattern(pattern), setting)
                .responses({});
        };
        const auto full = responses("full");
        const auto corotational = responses("corotational");
        for (std::size_t s = 0; s < full.size(); ++s) {
            const auto error = [&](std::size_t k) {
                return relative_difference(corotational[s].samples[k].displacements,
                                           full[s].samples[k].displacements);
            };
            EXPECT_LT(error(1), 0.01) << pattern << " " << full[s].scenario;
            // In proportion, or faster where symmetry leaves no term of second order.
            EXPECT_LT(error(0), 0.55 * error(1)) << pattern << " " << full[s].scenario;
        }
    }
}

TEST(CorotationalTile, FollowsItsFullModelThroughAnyTurnOfTheWhole) {
    for (const char* pattern : kPatterns) {
        const auto turned_and_loaded = [&](const std::string& model) {
            mechanics::Assembly tile = tile_of(model, pattern);
            tile.supports.push_back({mechanics::NodeIndex(0), mechanics::DofSet::all()});
            tile.prescribed.push_back({mechanics::NodeIndex(0), mechanics::Dof::ry, 4.0});
            tile.loads(3, 0) = 1e-4;
            tile.loads(2, 2) = 1e-4;
            return interface_displacements(tile);
        };
        const auto full = turned_and_loaded("full");
        EXPECT_LT(relative_difference(turned_and_loaded("corotational"), full), 1e-5) << pattern;
    }
}

TEST(CorotationalTile, VibratesAsItsFullModelDoesAtLowFrequencies) {
    for (const char* pattern : kPatterns) {
        const auto frequency = [&](const std::string& model) {
            mechanics::Assembly tile = tile_of(model, pattern);
            tile.supports.push_back({mechanics::NodeIndex(0), mechanics::DofSet::all()});
            return mechanics::vibration_modes(tile, 1).at(0).value;
        };
        const double full = frequency("full");
        const double corotational = frequency("corotational");
        // Held statically, inner nodes make a structure too stiff, never too soft.
        EXPECT_GT(corotational, full * (1.0 - 1e-9)) << pattern;
        EXPECT_LT(corotational, full * 1.01) << pattern;
    }
}

}  // namespace THIS_TEST
}  // namespace fretwork::reduction

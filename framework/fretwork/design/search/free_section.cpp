// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/design/search/free_section.hpp>
#include <fretwork/mechanics/frame/section.hpp>

#include <cmath>
#include <string>

namespace fretwork::design::detail {
namespace {

/// A tolerance: files have about six digits.
constexpr double kSameSection = 1e-6;

bool is_near(double a, double b) {
    return std::abs(a - b) <= kSameSection * std::abs(b);
}

}  // namespace

void require_rectangle(const mechanics::Section& section) {
    const mechanics::Section own = mechanics::rectangle_section(mechanics::rectangle_width(section),
                                                                mechanics::rectangle_height(section));
    const bool is_other_shape =
        section.shape && !std::holds_alternative<mechanics::RectangleShape>(*section.shape);
    if (is_other_shape || !is_near(section.area, own.area) || !is_near(section.J, own.J))
        throw base::InputError(
            "the section of the bars is no rectangle (" +
            std::string(is_other_shape ? mechanics::shape_name(*section.shape) : "other numbers") +
            "), which free width and thickness need");
}

reduction::Setting with_section(reduction::Setting setting, double width, double thickness) {
    const mechanics::Section before = setting.section;
    setting.section = mechanics::rectangle_section(width, thickness);
    const double larger = setting.section.area / before.area;
    if (before.shear_area2) setting.section.shear_area2 = larger * *before.shear_area2;
    if (before.shear_area3) setting.section.shear_area3 = larger * *before.shear_area3;
    if (before.shape) setting.section.shape = mechanics::RectangleShape{width, thickness};
    return setting;
}

Eigen::VectorXd residuals_by(
    const CaseModel& model, const TileStrains& strains, const simulation::CandidateTiles& candidates,
    const base::IndexVector<tiling::TileIndex, std::shared_ptr<const simulation::TileRate>>& rates) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(model.residual.size());
    for (const tiling::TileIndex tile : model.tiles.indices()) {
        const CaseModel::Tile& own = model.tiles[tile];
        const Eigen::MatrixXd& basis = strains.basis(candidates.class_of(tile));
        const Eigen::VectorXd stress =
            basis.transpose() *
            (rates[tile]->stiffness.selfadjointView<Eigen::Lower>() * (basis * own.strains));
        sum += rates[tile]->mass * own.of_weight - own.reach * stress;
    }
    return sum;
}

}  // namespace fretwork::design::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/box_grid.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::geometry {
namespace {

/// A box that meets more cells, 8 by 8, is in a list that every search looks through. Few boxes are so large,
/// but if thousands lie in one another, their cells would fill the memory.
constexpr std::size_t kMostCells = 64;

/// The number of cells along an extent; 1 if one of the two is not finite.
std::size_t cells_along(double extent, double cell) {
    const double cells = extent / cell;
    return std::isfinite(cells) ? static_cast<std::size_t>(cells) + 1 : 1;
}

}  // namespace

BoxGrid::BoxGrid(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
    if (!boxes_.empty()) bounds_ = boxes_.front();
    for (const Box& box : boxes_) bounds_ = united(bounds_, box);
    const double count = std::max<double>(1.0, static_cast<double>(boxes_.size()));
    const double longest = std::max({bounds_.width(), bounds_.height(), 1e-9});
    // The roots first, because the area of large boxes may be too large for a number.
    cell_ = std::max(std::sqrt(bounds_.width()) * std::sqrt(bounds_.height()) / std::sqrt(count),
                     longest / count);
    columns_ = cells_along(bounds_.width(), cell_);
    rows_ = cells_along(bounds_.height(), cell_);
    buckets_.resize(columns_ * rows_);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Cells range = cells(boxes_[i]);
        if ((range.x1 - range.x0 + 1) * (range.y1 - range.y0 + 1) > kMostCells) {
            large_.push_back(i);
            continue;
        }
        for (std::size_t y = range.y0; y <= range.y1; ++y)
            for (std::size_t x = range.x0; x <= range.x1; ++x) buckets_[y * columns_ + x].push_back(i);
    }
}

BoxGrid::Cells BoxGrid::cells(const Box& box) const {
    const auto index = [&](double offset, std::size_t count) {
        const double place = offset / cell_;
        if (!(place > 0.0)) return std::size_t{0};  // NaN, too
        return place < static_cast<double>(count) ? static_cast<std::size_t>(place) : count - 1;
    };
    return {index(box.xmin - bounds_.xmin, columns_), index(box.ymin - bounds_.ymin, rows_),
            index(box.xmax - bounds_.xmin, columns_), index(box.ymax - bounds_.ymin, rows_)};
}

std::vector<std::size_t> BoxGrid::meeting(const Box& box) const {
    std::vector<std::size_t> found;
    for (const std::size_t i : large_)
        if (boxes_[i].meets(box)) found.push_back(i);
    const Cells range = cells(box);
    for (std::size_t y = range.y0; y <= range.y1; ++y) {
        for (std::size_t x = range.x0; x <= range.x1; ++x) {
            for (const std::size_t i : buckets_[y * columns_ + x])
                if (boxes_[i].meets(box)) found.push_back(i);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace fretwork::geometry

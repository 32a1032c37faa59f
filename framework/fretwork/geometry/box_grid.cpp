// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/box_grid.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::geometry {

BoxGrid::BoxGrid(std::span<const Box> boxes) : boxes_(boxes.begin(), boxes.end()) {
    if (!boxes_.empty()) bounds_ = boxes_.front();
    for (const Box& box : boxes_) bounds_ = united(bounds_, box);
    const double count = std::max<double>(1.0, static_cast<double>(boxes_.size()));
    const double longest = std::max({bounds_.width(), bounds_.height(), 1e-9});
    cell_ = std::max(std::sqrt(bounds_.width() * bounds_.height() / count), longest / count);
    columns_ = static_cast<std::size_t>(bounds_.width() / cell_) + 1;
    rows_ = static_cast<std::size_t>(bounds_.height() / cell_) + 1;
    buckets_.resize(columns_ * rows_);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const Cells range = cells(boxes_[i]);
        for (std::size_t y = range.y0; y <= range.y1; ++y)
            for (std::size_t x = range.x0; x <= range.x1; ++x) buckets_[y * columns_ + x].push_back(i);
    }
}

BoxGrid::Cells BoxGrid::cells(const Box& box) const {
    const auto index = [&](double offset, std::size_t count) {
        return static_cast<std::size_t>(std::clamp(offset / cell_, 0.0, static_cast<double>(count - 1)));
    };
    return {index(box.xmin - bounds_.xmin, columns_), index(box.ymin - bounds_.ymin, rows_),
            index(box.xmax - bounds_.xmin, columns_), index(box.ymax - bounds_.ymin, rows_)};
}

std::vector<std::size_t> BoxGrid::meeting(const Box& box) const {
    std::vector<std::size_t> found;
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

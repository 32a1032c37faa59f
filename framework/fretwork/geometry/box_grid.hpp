// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/geometry/box.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace fretwork::geometry {

/// A grid of equal cells that finds, among many boxes, those that meet a given box. Const functions are
/// thread-safe.
class BoxGrid {
  public:
    /// Build a grid with about as many cells as boxes. Boxes may have any size, and places that are not
    /// finite.
    explicit BoxGrid(std::span<const Box> boxes);

    /// The numbers of the boxes that meet a box, ascending.
    [[nodiscard]] std::vector<std::size_t> meeting(const Box& box) const;

  private:
    struct Cells {
        std::size_t x0, y0, x1, y1;
    };
    [[nodiscard]] Cells cells(const Box& box) const;

    std::vector<Box> boxes_;
    Box bounds_;
    double cell_ = 1.0;  ///< m
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    std::vector<std::vector<std::size_t>> buckets_;
    std::vector<std::size_t> large_;  ///< the boxes that are in no bucket
};

}  // namespace fretwork::geometry

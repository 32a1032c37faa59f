// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/project/painting_choice.hpp>
#include <fretwork/tiling/painting/painting.hpp>

#include <string>
#include <utility>
#include <vector>

namespace fretwork::simulation::detail {

/// The patterns of these ids; an error names `entry` of the choice.
std::vector<pattern::NamedPattern> checked_palette(const std::string& entry,
                                                   const pattern::NodeLayout& layout,
                                                   const std::vector<std::string>& ids);

/// The patterns of a palette: those that it lists, its file's, or the library's calibrated ones.
std::vector<pattern::NamedPattern> palette_of(const PaletteChoice& palette, const PaintingGround& ground);
/// The patterns of the palette with their weights. Throws InputError if the numbers of both differ.
std::vector<tiling::WeightedPattern> weighted_palette(const PaintAtRandom& choice,
                                                      const PaintingGround& ground);
/// The patterns of the palette with their values: the property or, without one, the middles of equal parts of
/// 0 to 1. With dithering, these values reach from 0 to 1.
std::vector<tiling::GradedPattern> graded_palette(const PaintByField& choice, const PaintingGround& ground);
/// Colours as "#rrggbb", each with a pattern. Throws InputError if a colour is listed twice.
std::vector<std::pair<std::string, pattern::NamedPattern>> coloured_palette(const PaintByColours& choice,
                                                                            const PaintingGround& ground);

/// The wanted values where the field is 0 and 1: values of the property or, without a property, 0 and 1.
std::pair<double, double> wanted_range(const PaintByField& choice,
                                       const std::vector<tiling::GradedPattern>& palette);

}  // namespace fretwork::simulation::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scenarios.hpp"

#include <optional>

namespace fretwork::tile_models {

/// One model on one loaded surface.
struct SurfaceRow {
    int surface = 0;
    std::string kind;  ///< of load
    std::size_t tiles = 0;
    double wanted = 0.0;      ///< largest displacement as a share of the span
    double deflection = 0.0;  ///< the same, of the full model
    std::string model;
    std::optional<double> mean_error;  ///< of the largest displacement; none: no equilibrium was found
    std::optional<double> largest_error;
    double seconds = 0.0;
    int iterations = 0;
};

/// Random rectangles of regular size painted with eight of the patterns each, under loads of several kinds,
/// each scaled until the corotational model is deflected as far as wanted; every reduced model beside the
/// full one.
std::vector<SurfaceRow> study_surfaces(const reduction::Setting& setting,
                                       const std::vector<CalibratedPattern>& patterns, int repeats);

}  // namespace fretwork::tile_models

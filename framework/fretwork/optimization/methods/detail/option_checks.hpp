// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace fretwork::optimization::detail {

/// Throws InputError with the option's name and value unless `value` is at least `least`.
void require_at_least(double least, std::string_view option, double value);

/// Throws InputError with the option's name and value unless `value` is more than `bound`.
void require_more_than(double bound, std::string_view option, double value);

/// Throws InputError with the first wrong value unless the smoothing lengths of a continuation fall from one
/// stage to the next (or stay equal), none is negative, and there is at least one.
void require_smoothing(std::span<const double> smoothing);

}  // namespace fretwork::optimization::detail

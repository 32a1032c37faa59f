// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/methods/detail/option_checks.hpp>

#include <limits>
#include <string>

namespace fretwork::optimization::detail {
namespace {

[[noreturn]] void refuse(std::string_view option, double value, const std::string& valid) {
    throw base::InputError(std::string(option) + ": " + base::format_number(value) + " must be " + valid);
}

}  // namespace

void require_at_least(double least, std::string_view option, double value) {
    if (!(value >= least)) refuse(option, value, "at least " + base::format_number(least));
}

void require_more_than(double bound, std::string_view option, double value) {
    if (!(value > bound)) refuse(option, value, "more than " + base::format_number(bound));
}

void require_smoothing(std::span<const double> smoothing) {
    if (smoothing.empty()) throw base::InputError("smoothing: at least one length is needed");
    double before = std::numeric_limits<double>::infinity();
    for (const double length : smoothing) {
        require_at_least(0.0, "smoothing", length);
        if (length > before)
            refuse("smoothing", length, "at most the length before it, " + base::format_number(before));
        before = length;
    }
}

}  // namespace fretwork::optimization::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/limits.hpp>
#include <fretwork/base/text.hpp>

namespace fretwork::base {
namespace {

std::string between(double low, double high, std::string_view unit) {
    return "a number from " + format_number(low) + " to " + format_number(high) + " (" + std::string(unit) +
           ")";
}

}  // namespace

std::string positive_range_text(const Limits& limits) {
    return between(limits.least, limits.most, limits.unit);
}

std::string range_text(const Limits& limits) {
    return between(-limits.most, limits.most, limits.unit);
}

}  // namespace fretwork::base

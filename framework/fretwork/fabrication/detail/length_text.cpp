// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/fabrication/detail/length_text.hpp>

#include <array>
#include <cstdio>

namespace fretwork::fabrication::detail {

std::string short_number(double value) {
    std::array<char, 32> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
    return buffer.data();
}

std::string millimetres(double metres) {
    return short_number(1e3 * metres) + " mm";
}

}  // namespace fretwork::fabrication::detail

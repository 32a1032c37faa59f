// SPDX-License-Identifier: GPL-3.0-or-later
#include "complaint.hpp"

#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace fretwork::app {

void complain(std::string message) {
    constexpr std::string_view kStart = "fretwork: ";
    constexpr std::size_t kLongestLine = 300;
    std::ranges::replace(message, '\n', ' ');
    const std::string line = base::shortened(base::printable(message), kLongestLine - kStart.size());
    std::fprintf(stderr, "%s%s\n", std::string(kStart).c_str(), line.c_str());
}

}  // namespace fretwork::app

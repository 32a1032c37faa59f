// SPDX-License-Identifier: GPL-3.0-or-later
#include "output.hpp"

#include <fretwork/base/text.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace fretwork::app {
namespace {

constexpr std::string_view kLineStart = "fretwork: ";

}  // namespace

void complain(std::string message) {
    constexpr std::size_t kLongestLine = 300;
    std::ranges::replace(message, '\n', ' ');
    warn(base::shortened(base::printable(message), kLongestLine - kLineStart.size()));
}

void warn(const std::string& line) {
    std::fprintf(stderr, "%s%s\n", std::string(kLineStart).c_str(), base::printable(line).c_str());
}

std::string bytes_text(std::size_t bytes) {
    constexpr double kKilo = 1000.0;
    constexpr double kRoundedUp = 999.5;  // from here on, three digits would make it 1000
    auto size = static_cast<double>(bytes);
    if (size < kKilo) return std::to_string(bytes) + " bytes";
    for (const char* unit : {" kB", " MB"}) {
        size /= kKilo;
        if (size < kRoundedUp) return base::format_number(size, 3) + unit;
    }
    return base::format_number(size / kKilo, 3) + " GB";
}

void print_document(const base::Json& document) {
    std::fputs(base::json_text(document).c_str(), stdout);
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace fretwork::experiments {

double Distribution::quantile(double share) const {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Distribution distribution(std::vector<double> values) {
    Distribution result;
    if (values.empty()) values.push_back(0.0);
    const auto count = static_cast<double>(values.size());
    result.mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    for (const double value : values)
        result.deviation += (value - result.mean) * (value - result.mean) / count;
    result.deviation = std::sqrt(result.deviation);
    std::ranges::sort(values);
    result.sorted = std::move(values);
    return result;
}

void print_row(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) std::printf("| %s ", cell.c_str());
    std::printf("|\n");
}

void print_head(const std::vector<std::string>& cells) {
    print_row(cells);
    for (std::size_t i = 0; i < cells.size(); ++i) std::printf("|---");
    std::printf("|\n");
}

std::string fixed(double value, int digits) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
    return buffer;
}

}  // namespace fretwork::experiments

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/detail/remarks.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace fretwork::outlines::detail {

namespace {

constexpr std::size_t kMostKinds = 6;
constexpr std::size_t kLongestKind = 60;

}  // namespace

void Remarks::add_changes(const Region& region, double tolerance) {
    const std::string width = roughly_in_millimetres(tolerance) + " mm";
    if (region.doubled > 0)
        add(base::counted(region.doubled, "shape") + " drawn over an equal one counted once");
    if (region.touches > 0)
        add(base::counted(region.touches, "point") + " where the shape touches itself opened by " + width);
    if (region.slits > 0) add(base::counted(region.slits, "hole") + " narrower than " + width + " filled");
    if (region.is_welded)
        add("slits and needles narrower than " + roughly_in_millimetres(kWeldShare * tolerance) +
            " mm closed or cut off");
}

std::vector<std::string> Remarks::list() const {
    std::vector<std::string> list = remarks_;
    if (std::string text = left_out(); !text.empty()) list.push_back(std::move(text));
    return list;
}

std::string Remarks::left_out() const {
    std::vector<std::pair<std::string, int>> kinds(left_out_.begin(), left_out_.end());
    std::ranges::stable_sort(kinds, std::ranges::greater{}, &std::pair<std::string, int>::second);
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min(kinds.size(), kMostKinds); ++i)
        words.push_back(std::to_string(kinds[i].second) + " " +
                        base::shortened(base::printable(kinds[i].first), kLongestKind));
    if (kinds.size() > kMostKinds)
        words.push_back("things of " + std::to_string(kinds.size() - kMostKinds) + " more kinds");
    return words.empty() ? "" : base::join(words, ", ") + " left out";
}

std::string in_millimetres(double length) {
    const double millimetres = 1e3 * length;
    char text[32];
    std::snprintf(text, sizeof text, std::abs(millimetres) < 1e3 ? "%.4g" : "%.0f", millimetres);
    return text;
}

std::string roughly_in_millimetres(double length) {
    if (!(length > 0)) return "0";
    constexpr double kRounding = 1e-9;  // keeps 0.02 at 0.02
    const double digit = std::pow(10, std::floor(std::log10(length)) - 1);
    return in_millimetres(digit * std::ceil(length / digit - kRounding));
}

}  // namespace fretwork::outlines::detail

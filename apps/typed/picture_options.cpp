// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <typed/picture_options.hpp>

namespace fretwork::typed {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct NamedView {
    std::string_view name;
    double azimuth;    ///< degrees
    double elevation;  ///< degrees
};
constexpr std::array<NamedView, 6> kViews = {{{"iso", 45.0, 35.264389682754654},
                                              {"front", 0.0, 10.0},
                                              {"right", 90.0, 10.0},
                                              {"back", 180.0, 10.0},
                                              {"left", 270.0, 10.0},
                                              {"top", 0.0, 90.0}}};

constexpr double kLargestScale = 1e9;

[[noreturn]] void refuse_scale(const std::string& text) {
    throw base::InputError("'" + text + "' is not a number from -1e9 to 1e9");
}

}  // namespace

exports::ViewOptions parse_view(const std::string& text) {
    const auto named = std::ranges::find(kViews, text, &NamedView::name);
    if (named != kViews.end()) return {named->azimuth * kDegree, named->elevation * kDegree};
    const auto parts = base::split(text, ',');
    const auto angle = [&](std::size_t part) { return base::read_number<double>(parts[part]); };
    if (parts.size() != 2 || !angle(0) || !angle(1) || !(std::abs(*angle(0)) <= 360.0) ||
        !(std::abs(*angle(1)) <= 90.0))
        throw base::InputError(
            "'" + text +
            "' is neither iso, front, right, back, left, top nor AZIMUTH,ELEVATION in degrees, "
            "the azimuth from -360 to 360, the elevation from -90 to 90");
    return {*angle(0) * kDegree, *angle(1) * kDegree};
}

double checked_scale(double scale) {
    if (!(std::abs(scale) <= kLargestScale)) refuse_scale(base::format_number(scale));
    return scale;
}

double parse_scale(const std::string& text) {
    const auto number = base::read_number<double>(text);
    if (!number || !(std::abs(*number) <= kLargestScale)) refuse_scale(text);
    return *number;
}

exports::PixelSize parse_size(const std::string& text) {
    constexpr int kMost = 8000;
    const auto parts = base::split(text, 'x');
    const auto side = [&](std::size_t part) { return base::read_number<int>(parts[part]).value_or(0); };
    const auto is_fine = [](int pixels) { return pixels >= 16 && pixels <= kMost; };
    if (parts.size() != 2 || !is_fine(side(0)) || !is_fine(side(1)))
        throw base::InputError("'" + text + "' is not WIDTHxHEIGHT in pixels from 16 to " +
                               std::to_string(kMost));
    return {side(0), side(1)};
}

}  // namespace fretwork::typed

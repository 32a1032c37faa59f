// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/space/detail/bar_colours.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::exports::detail {

using Eigen::Vector3f;

float linear_light(double screen) {
    return static_cast<float>(screen <= 0.04045 ? screen / 12.92 : std::pow((screen + 0.055) / 1.055, 2.4));
}

Vector3f linear_colour(const std::string& text) {
    const auto [red, green, blue] = colour_bytes(text);
    return {linear_light(red / 255.0), linear_light(green / 255.0), linear_light(blue / 255.0)};
}

EndColours end_colours(const BarScene& scene, const std::string& name) {
    if (name == kPlainColour || scene.fields.empty())
        return EndColours(2 * scene.bars.size(), linear_colour("#d9cdb8"));
    const auto field = std::ranges::find(scene.fields, name, &BarScene::Field::name);
    if (field == scene.fields.end() && name == kUtilization)
        throw base::InputError(
            "utilization needs a strength: give one, or write \"strength\" into the material of the setting");
    if (field == scene.fields.end()) {
        std::vector<std::string> names = bar_field_names();
        names.emplace_back(kPlainColour);
        throw base::InputError(base::unknown_name_message("field", name, names));
    }
    if (std::ranges::all_of(field->values, [](double value) { return std::isnan(value); }))
        throw base::InputError(name +
                               " is not known with the result's model: beams are recovered from full and "
                               "condensed tiles");
    const ValueRange range = value_range(field->values);
    EndColours colours;
    for (const double value : field->values) colours.push_back(linear_colour(value_colour(value, range)));
    return colours;
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/limits.hpp>
#include <fretwork/mechanics/internal/section_json.hpp>

#include <array>
#include <string>
#include <vector>

namespace fretwork::mechanics {
namespace {

using base::Json;
using base::JsonReader;

/// Call visit(key, length) for each length of a shape.
template <class Shape, class Visit>
void for_each_length(Shape& shape, const Visit& visit) {
    if constexpr (requires { shape.flange_thickness; }) {
        visit("width", shape.width);
        visit("height", shape.height);
        visit("flange_thickness", shape.flange_thickness);
        visit("web_thickness", shape.web_thickness);
    } else if constexpr (requires { shape.width; }) {
        visit("width", shape.width);
        visit("height", shape.height);
    } else if constexpr (requires { shape.diameter; }) {
        visit("diameter", shape.diameter);
    } else {
        visit("outer_diameter", shape.outer_diameter);
        visit("inner_diameter", shape.inner_diameter);
    }
}

SectionShape shape_named(const std::string& type) {
    for (const SectionShape& shape :
         std::array<SectionShape, 4>{RectangleShape(), CircleShape(), TubeShape(), IShape()})
        if (type == shape_name(shape)) return shape;
    return RectangleShape();
}

/// Lengths have limits of their own, because numbers made of them, such as an area, are not in the file.
double read_length(const JsonReader& json) {
    const double length = json.positive_number();
    if (!base::is_positive_within(length, base::kLengthLimits))
        json.fail("is " + json.text() + ", where " + base::positive_range_text(base::kLengthLimits) +
                  " is needed");
    return length;
}

Section fitting_section(const JsonReader& json, const SectionShape& shape) {
    const auto* tube = std::get_if<TubeShape>(&shape);
    if (tube != nullptr && tube->inner_diameter >= tube->outer_diameter)
        json.at("inner_diameter")
            .fail("is " + json.at("inner_diameter").text() + ", which is not below the outer diameter");
    return json.located([&] { return section_of(shape); });
}

Section read_typed_section(const JsonReader& json) {
    SectionShape shape = shape_named(json.at("type").choice({"rectangle", "circle", "tube", "I"}));
    std::vector<std::string_view> keys{"type", "shear_area2", "shear_area3"};
    std::visit(
        [&](auto& own) { for_each_length(own, [&](const char* key, double&) { keys.emplace_back(key); }); },
        shape);
    json.allow_only(keys);
    std::visit(
        [&](auto& own) {
            for_each_length(own,
                            [&](const char* key, double& length) { length = read_length(json.at(key)); });
        },
        shape);
    return fitting_section(json, shape);
}

Section read_numbers(const JsonReader& json) {
    if (!json.find("area") && (json.find("width") || json.find("diameter") || json.find("outer_diameter")))
        json.fail("the key 'type' is missing, which says what the lengths are: rectangle, circle, tube or I");
    json.allow_only({"area", "I2", "I3", "J", "shear_area2", "shear_area3"});
    return {.area = json.at("area").positive_number(),
            .I2 = json.at("I2").positive_number(),
            .I3 = json.at("I3").positive_number(),
            .J = json.at("J").positive_number()};
}

/// True if a section has a shape other than a rectangle, and if its area and moments are still those of this
/// shape. Shear areas do not matter.
bool is_written_by_type(const Section& section) {
    if (!section.shape || std::holds_alternative<RectangleShape>(*section.shape)) return false;
    try {
        Section made = section_of(*section.shape);
        made.shear_area2 = section.shear_area2;
        made.shear_area3 = section.shear_area3;
        return made == section;
    } catch (const base::InputError&) {  // no section has this shape
        return false;
    }
}

}  // namespace

Section read_section(const JsonReader& json) {
    Section section = json.find("type") ? read_typed_section(json) : read_numbers(json);
    if (const auto area = json.find("shear_area2")) section.shear_area2 = area->positive_number();
    if (const auto area = json.find("shear_area3")) section.shear_area3 = area->positive_number();
    return section;
}

Json section_json(const Section& section) {
    Json json;
    if (is_written_by_type(section)) {
        json["type"] = shape_name(*section.shape);
        std::visit(
            [&](const auto& own) {
                for_each_length(own, [&](const char* key, const double& length) { json[key] = length; });
            },
            *section.shape);
    } else {
        json = {{"area", section.area}, {"I2", section.I2}, {"I3", section.I3}, {"J", section.J}};
    }
    if (section.shear_area2) json["shear_area2"] = *section.shear_area2;
    if (section.shear_area3) json["shear_area3"] = *section.shear_area3;
    return json;
}

bool is_of_newer_format(const Section& section) {
    return is_written_by_type(section) && std::holds_alternative<IShape>(*section.shape);
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/geometry/polygon.hpp>
#include <studio/document/json_lists.hpp>
#include <studio/server/sent_outline.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace fretwork::studio {

using base::Json;

namespace {

std::array<double, 2> size_of(std::span<const outlines::Outline> parts) {
    std::array<double, 2> low{HUGE_VAL, HUGE_VAL};
    std::array<double, 2> high{-HUGE_VAL, -HUGE_VAL};
    for (const outlines::Outline& part : parts) {
        for (const geometry::Point2& point : part.boundary) {
            low = {std::min(low[0], point.x), std::min(low[1], point.y)};
            high = {std::max(high[0], point.x), std::max(high[1], point.y)};
        }
    }
    return {high[0] - low[0], high[1] - low[1]};
}

}  // namespace

SentOutline read_sent_outline(const base::JsonReader& json) {
    json.allow_only({"name", "text_base64", "part", "width"});
    SentOutline sent{parse_sent_file(json)};
    if (const auto part = json.find("part")) sent.part = part->string();
    if (const auto width = json.find("width")) sent.width = width->positive_number();
    return sent;
}

TakenOutline take_outline(const SentOutline& sent) {
    return read_sent(sent.file, [&](const std::filesystem::path& path) {
        outlines::OutlineFile file = outlines::read_outline_file(path);
        TakenOutline taken;
        for (const outlines::Outline& part : file.parts) taken.sizes.push_back(size_of({&part, 1}));
        taken.file = outlines::take_parts(std::move(file), sent.part);
        if (!sent.width) return taken;
        taken.factor = *sent.width / size_of(taken.file.parts)[0];
        taken.file = outlines::scaled_to_width(std::move(taken.file), *sent.width);
        for (auto& size : taken.sizes) size = {taken.factor * size[0], taken.factor * size[1]};
        return taken;
    });
}

Json measured(const TakenOutline& outline) {
    Json loops = Json::array();
    double area = 0;
    for (const outlines::Outline& part : outline.file.parts) {
        loops.push_back(points_json(part.boundary));
        area += std::abs(geometry::signed_area(part.boundary));
        for (const geometry::Polygon& hole : part.holes) {
            loops.push_back(points_json(hole));
            area -= std::abs(geometry::signed_area(hole));
        }
    }
    return {{"size", size_of(outline.file.parts)},
            {"area", area},
            {"loops", loops},
            {"parts", outline.sizes},
            {"remarks", outline.file.remarks}};
}

}  // namespace fretwork::studio

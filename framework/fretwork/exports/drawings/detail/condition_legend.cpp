// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/condition_legend.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;
using Kind = LoadMark::Kind;
using Shape = LoadMark::Shape;

// In heights of the text.
constexpr double kLegendLine = 1.6;
constexpr double kLegendGap = 1.5;

std::string force_text(double newtons) {
    return newtons < 0.1 ? short_number(1e3 * newtons) + " mN" : short_number(newtons) + " N";
}

/// The largest force and moment at a node, and how many there are.
struct LoadFacts {
    double largest_force = 0.0;
    double largest_moment = 0.0;
    std::size_t count = 0;
};

LoadFacts facts_of(const simulation::Conditions& conditions) {
    LoadFacts facts;
    for (const mechanics::NodalLoad& load : loads_by_node(conditions)) {
        facts.largest_force = std::max(facts.largest_force, load.force.norm());
        facts.largest_moment = std::max(facts.largest_moment, load.moment.norm());
        facts.count += (load.force.norm() > 0.0 ? 1 : 0) + (load.moment.norm() > 0.0 ? 1 : 0);
    }
    return facts;
}

double symbol_width(bool is_ball, const std::optional<LoadMark>& load) {
    if (is_ball) return 1.8;
    if (!load) return 0.0;
    return load->shape == Shape::Arrow ? 3.2 : 1.5;
}

}  // namespace

ConditionLegend::ConditionLegend(std::span<const SupportMark> supports, std::span<const LoadMark> loads,
                                 const simulation::Conditions& conditions) {
    for (const SupportMark& mark : supports) {
        const auto same = [&](const Entry& other) { return other.words == mark.meaning; };
        if (std::ranges::none_of(entries_, same)) entries_.push_back({mark, std::nullopt, mark.meaning});
    }
    const LoadFacts facts = facts_of(conditions);
    if (facts.largest_force > 0.0)
        add_loads(Kind::Force, loads, "forces, the largest " + force_text(facts.largest_force));
    if (facts.largest_moment > 0.0)
        add_loads(Kind::Moment, loads,
                  "moments, the largest " + short_number(1e3 * facts.largest_moment) + " N mm");
    if (loads.size() < facts.count)
        entries_.push_back({std::nullopt, std::nullopt,
                            std::to_string(loads.size()) + " of " + std::to_string(facts.count) + " drawn"});
}

/// One entry for each shape that is drawn; the first says what they are.
void ConditionLegend::add_loads(Kind kind, std::span<const LoadMark> drawn, std::string words) {
    const std::pair<Shape, const char*> kShapes[] = {
        {Shape::Arrow, ""}, {Shape::AwayFromViewer, "away from you"}, {Shape::TowardsViewer, "towards you"}};
    for (const auto& [shape, where] : kShapes) {
        const auto alike = [&, seen = shape](const LoadMark& mark) {
            return mark.kind == kind && mark.shape == seen;
        };
        const auto found = std::ranges::find_if(drawn, alike);
        if (found == drawn.end()) continue;
        const std::string both = words + (words.empty() || *where == '\0' ? "" : ", ") + where;
        entries_.push_back({std::nullopt, *found, both});
        words.clear();
    }
}

std::vector<Point2> ConditionLegend::places(double width) const {
    std::vector<Point2> places;
    Point2 place{0.0, -1.0};
    for (const Entry& entry : entries_) {
        const double size =
            symbol_width(entry.support.has_value(), entry.load) + text_width(entry.words, 1.0);
        if (place.x > 0.0 && place.x + size > width) place = {0.0, place.y - kLegendLine};
        places.push_back(place);
        place.x += size + kLegendGap;
    }
    return places;
}

double ConditionLegend::height(double width, double text) const {
    const std::vector<Point2> all = places(width / text);
    return all.empty() ? 0.0 : text * (0.6 - all.back().y);
}

void ConditionLegend::draw(SvgCanvas& canvas, const Point2& top_left, double width, double text) const {
    canvas.layer("legend of conditions");
    const std::vector<Point2> all = places(width / text);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        const Point2 place{top_left.x + text * all[i].x, top_left.y + text * all[i].y};
        const double middle = place.y + 0.35 * text;
        if (entry.support)
            draw_support(canvas, {{place.x + 0.6 * text, middle}, entry.support->colour, entry.words},
                         0.6 * text);
        if (entry.load) {
            const double size = 2.6 * text;
            const double start = place.x + (entry.load->shape == Shape::Arrow ? 0.0 : 0.5 * text);
            draw_load(canvas,
                      {entry.load->kind, entry.load->shape, {start, middle}, {place.x + size, middle}, size});
        }
        canvas.text({place.x + text * symbol_width(entry.support.has_value(), entry.load), place.y},
                    entry.words, text);
    }
}

}  // namespace fretwork::exports::detail

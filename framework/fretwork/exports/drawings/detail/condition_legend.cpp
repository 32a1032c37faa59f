// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/exports/drawings/detail/condition_legend.hpp>
#include <fretwork/exports/drawings/detail/furniture.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fretwork::exports::detail {
namespace {

using geometry::Point2;
using simulation::Conditions;

constexpr double kLineHeight = 1.6;  // as multiples of the text's height, as all below
constexpr double kGap = 1.5;         // behind an entry
constexpr double kBallWidth = 1.8;
constexpr double kRingWidth = 1.5;
constexpr double kArrowWidth = 3.2;
constexpr double kLoadSize = 2.6;

std::string force_text(double newtons) {
    return newtons < 0.1 ? short_number(1e3 * newtons) + " mN" : short_number(newtons) + " N";
}

/// "forces", "weight", or both.
std::string forces_text(const Conditions& conditions) {
    const std::size_t own = conditions.loads.size() - conditions.weights;
    const bool has_forces =
        std::any_of(conditions.loads.begin(), conditions.loads.begin() + static_cast<std::ptrdiff_t>(own),
                    [](const auto& load) { return load.force.norm() > 0.0; });
    if (conditions.weights == 0) return "forces";
    return has_forces ? "forces and weight" : "weight";
}

}  // namespace

ConditionLegend::ConditionLegend(const ConditionMarks& marks, const Conditions* conditions, double width)
    : text_(text_height(width)) {
    if (conditions == nullptr) return;
    add_supports(marks);
    add_prescribed(*conditions);
    add_loads(marks, *conditions);
    place_entries(width - 2.0 * text_);
}

double ConditionLegend::height() const {
    return kLineHeight * text_ * lines_;
}

void ConditionLegend::add_supports(const ConditionMarks& marks) {
    for (const SupportMark& mark : marks.supports) {
        const auto same = [&](const Entry& entry) { return entry.words == mark.meaning; };
        if (std::ranges::none_of(entries_, same)) entries_.push_back({mark, mark.meaning, kBallWidth});
    }
}

/// One mark stands for displacements and rotations.
void ConditionLegend::add_prescribed(const Conditions& conditions) {
    std::vector<double> displacements;
    std::vector<double> rotations;
    for (const mechanics::PrescribedDisplacement& entry : conditions.prescribed)
        (entry.dof < mechanics::Dof::rx ? displacements : rotations).push_back(std::abs(entry.value));
    std::string words;
    if (!displacements.empty())
        words = "prescribed displacements, the largest " + millimetres(std::ranges::max(displacements));
    if (!rotations.empty())
        words += (words.empty() ? "prescribed rotations, the largest " : "; rotations, the largest ") +
                 short_number(std::ranges::max(rotations) * 180.0 / std::numbers::pi) + "\xc2\xb0";
    if (!words.empty()) entries_.push_back({Prescribed{}, words, kBallWidth});
}

void ConditionLegend::add_loads(const ConditionMarks& marks, const Conditions& conditions) {
    double largest_force = 0.0;
    double largest_moment = 0.0;
    std::size_t all = 0;
    for (const mechanics::NodalLoad& load : loads_of_nodes(conditions)) {
        largest_force = std::max(largest_force, load.force.norm());
        largest_moment = std::max(largest_moment, load.moment.norm());
        all += (load.force.norm() > 0.0 ? 1U : 0U) + (load.moment.norm() > 0.0 ? 1U : 0U);
    }
    if (largest_force > 0.0)
        add_load_kind(marks, LoadMark::Kind::Force,
                      forces_text(conditions) + ", the largest " + force_text(largest_force));
    if (largest_moment > 0.0)
        add_load_kind(marks, LoadMark::Kind::Moment,
                      "moments, the largest " + short_number(1e3 * largest_moment) + " N mm");
    if (marks.loads.size() < all)
        entries_.push_back(
            {Words{}, std::to_string(marks.loads.size()) + " of " + std::to_string(all) + " drawn"});
}

/// An entry for each shape that is drawn; the first one names the kind.
void ConditionLegend::add_load_kind(const ConditionMarks& marks, LoadMark::Kind kind, std::string words) {
    using Shape = LoadMark::Shape;
    const std::pair<Shape, const char*> kShapes[] = {
        {Shape::Arrow, ""}, {Shape::AwayFromViewer, "away from you"}, {Shape::TowardsViewer, "towards you"}};
    for (const auto& [shape, where] : kShapes) {
        const auto found = std::ranges::find_if(marks.loads, [&, wanted = shape](const LoadMark& mark) {
            return mark.kind == kind && mark.shape == wanted;
        });
        if (found == marks.loads.end()) continue;
        const std::string both = words + (words.empty() || *where == '\0' ? "" : ", ") + where;
        entries_.push_back({*found, both, shape == Shape::Arrow ? kArrowWidth : kRingWidth});
        words.clear();
    }
}

/// An entry that would reach beyond the width begins the next line.
void ConditionLegend::place_entries(double width) {
    lines_ = 1;
    double x = 0.0;
    for (Entry& entry : entries_) {
        const double needed = entry.mark_width * text_ + text_width(entry.words, text_);
        if (x > 0.0 && x + needed > width) {
            ++lines_;
            x = 0.0;
        }
        entry.line = lines_ - 1;
        entry.x = x;
        x += needed + kGap * text_;
    }
}

void ConditionLegend::draw(SvgCanvas& canvas, const Point2& start) const {
    canvas.layer("legend of conditions");
    for (const Entry& entry : entries_) {
        const Point2 place{start.x + entry.x, start.y - kLineHeight * text_ * entry.line};
        draw_mark(canvas, entry, place);
        canvas.text({place.x + entry.mark_width * text_, place.y}, entry.words, text_);
    }
}

void ConditionLegend::draw_mark(SvgCanvas& canvas, const Entry& entry, const Point2& place) const {
    const Point2 middle{place.x + 0.6 * text_, place.y + 0.35 * text_};
    if (const auto* support = std::get_if<SupportMark>(&entry.mark)) {
        draw_support(canvas, {middle, support->colour, support->meaning}, 0.6 * text_);
    } else if (std::holds_alternative<Prescribed>(entry.mark)) {
        draw_prescribed(canvas, middle, 0.6 * text_);
    } else if (const auto* load = std::get_if<LoadMark>(&entry.mark)) {
        const double size = kLoadSize * text_;
        const double from = place.x + (load->shape == LoadMark::Shape::Arrow ? 0.0 : 0.5 * text_);
        draw_load(canvas, {load->kind, load->shape, {from, middle.y}, {place.x + size, middle.y}, size});
    }
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <studio/document/history.hpp>

namespace fretwork::studio {

History::History(State first, Limits limits) : limits_(limits) {
    steps_.push_back({std::make_shared<const State>(std::move(first)), "", "", 0});
}

History::Step History::make_step(Edited edited) const {
    const std::size_t bytes = size_of_difference(edited.state, *now());
    return {std::make_shared<const State>(std::move(edited.state)), std::move(edited.label),
            std::move(edited.merge), bytes};
}

void History::add(Edited edited) {
    forget_undone();
    const bool merges = now_ > 0 && !edited.merge.empty() && steps_[now_].merge == edited.merge;
    Step step = make_step(std::move(edited));
    if (merges) {
        step.label = steps_[now_].label;
        bytes_ -= steps_[now_].bytes;
        steps_[now_] = std::move(step);
    } else {
        steps_.push_back(std::move(step));
        ++now_;
    }
    bytes_ += steps_[now_].bytes;
    forget_oldest();
}

void History::forget_undone() {
    while (steps_.size() > now_ + 1) {
        bytes_ -= steps_.back().bytes;
        steps_.pop_back();
    }
}

void History::forget_oldest() {
    while (now_ > 0 && (steps_.size() > limits_.steps || bytes_ > limits_.bytes)) {
        steps_.pop_front();
        --now_;
        bytes_ -= steps_.front().bytes;
        steps_.front().bytes = 0;
    }
}

bool History::undo() {
    if (now_ == 0) return false;
    --now_;
    steps_[now_].merge.clear();  // the next edit is a separate step
    return true;
}

bool History::redo() {
    if (now_ + 1 == steps_.size()) return false;
    ++now_;
    steps_[now_].merge.clear();
    return true;
}

std::optional<std::string> History::undo_label() const {
    if (now_ == 0) return std::nullopt;
    return steps_[now_].label;
}

std::optional<std::string> History::redo_label() const {
    if (now_ + 1 == steps_.size()) return std::nullopt;
    return steps_[now_ + 1].label;
}

}  // namespace fretwork::studio

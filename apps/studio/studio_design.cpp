// SPDX-License-Identifier: GPL-3.0-or-later
// Requests for designs.
#include <studio/studio_impl.hpp>

namespace fretwork::studio {

void Studio::Impl::begin_design(const Request& request) {
    const Situation situation = document().solver_input().situation;
    designs_.begin(situation.state, read_design(request.json, situation), document_->revision());
    pages_.answer(request);
}

void Studio::Impl::stop_design(const Request& request) {
    request.json.allow_only({"id", "do"});
    designs_.stop();
    pages_.answer(request);
}

/// The sketch and the answer of one design are one step of undo.
void Studio::Impl::take_design(const DesignFound& found) {
    const StatePtr before = document_->now();
    Edited edit = with_design(*before, found.report);
    if (edit.state == *before) return;
    edit.merge = designs_.merge_key();
    document_->add(std::move(edit));
    designs_.painted(document_->now());
    follow_change(*before);
}

}  // namespace fretwork::studio

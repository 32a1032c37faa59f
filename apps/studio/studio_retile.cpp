// SPDX-License-Identifier: GPL-3.0-or-later
// Other tiles for the outline of the document.
#include <fretwork/base/error.hpp>
#include <studio/studio_impl.hpp>

#include <utility>

namespace fretwork::studio {

/// The tiles are made on another thread, and put into the document as it is then.
void Studio::Impl::retile(const Request& request) {
    const StatePtr before = document().now();
    const RetileRequest wanted = read_retile(request.json, *before);
    const auto take = [this, request, before, wanted](const RetilingPtr& made) {
        last_retiling_ = made;
        if (!document_ || document_->now()->ground != before->ground)
            throw base::InputError("the surface got other tiles meanwhile: try again");
        const StatePtr now = document_->now();
        Retiled result = retiled(*now, *made, wanted.preview);
        pages_.answer(request, std::move(result.answer));
        if (wanted.preview == Preview::Yes) return;
        document_->add(std::move(result.edit));
        follow_change(*now);
    };
    if (last_retiling_ && gives_the_same(*last_retiling_, *before, wanted)) return take(last_retiling_);
    pages_.in_background(files_, request, [before, wanted, take](const base::Control& control) {
        const auto made = std::make_shared<const Retiling>(make_retiling(before, wanted, control));
        return [take, made] { take(made); };
    });
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
// The document, and the messages that show it to pages.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/colours.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <studio/document/document_json.hpp>
#include <studio/document/examples.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/studio_impl.hpp>

namespace fretwork::studio {

using base::Json;

namespace {

constexpr int kProtocol = 1;

Json models_json() {
    Json list = Json::array();
    for (const reduction::TileModel& model : reduction::tile_models()) {
        Json parameters = Json::array();
        for (const reduction::TileParameter& parameter : model.parameters)
            parameters.push_back({{"name", parameter.name}, {"unit", parameter.unit}});
        list.push_back({{"name", model.name},
                        {"summary", model.summary},
                        {"reference", model.role == reduction::Role::Reference},
                        {"large_displacements", model.displacements == reduction::Displacements::Large},
                        {"parameters", parameters}});
    }
    list.push_back(
        {{"name", "mixed"},
         {"summary", "corotational; full beams in the given share of tiles, those with the largest error"},
         {"reference", false},
         {"large_displacements", true},
         {"parameters", Json::array()},
         {"share", true}});
    return list;
}

Json examples_json() {
    Json list = Json::array();
    for (const Example& example : examples())
        list.push_back(
            {{"name", example.name}, {"title", example.title}, {"description", example.description}});
    return list;
}

/// The kinds of file that `fretwork export` writes: the default kind of each ending.
Json exports_json() {
    Json list = Json::array();
    for (const exports::WriterRow& writer : exports::writer_catalogue()) {
        if (exports::is_default(writer))
            list.push_back({{"ending", writer.ending}, {"summary", writer.description}});
    }
    return list;
}

}  // namespace

void Studio::Impl::hello(const Request& request) {
    request.json.allow_only({"id", "do", "protocol", "fields"});
    if (request.json.at("protocol").integer(0, 1000) != kProtocol)
        request.json.at("protocol")
            .fail("this server speaks protocol " + std::to_string(kProtocol) + "; load the page again");
    const auto fields = request.json.find("fields");
    pages_.show(request.client, fields ? read_beam_fields(*fields) : kAllBeamFields);
    pages_.answer(request,
                  {{"version", base::version()},
                   {"models", models_json()},
                   {"examples", examples_json()},
                   {"layouts", pattern::layout_names()},
                   {"has_library", document_ && !document_->now()->library->path.empty()},
                   {"has_document", document_.has_value()},
                   {"exports", exports_json()},
                   {"colours", {{"sizes", exports::scale_samples()}, {"signed", exports::signed_samples()}}},
                   {"recoverable", kept_.recoverable_json()}});
    if (!kept_.trouble().empty()) pages_.send(request.client, warning_event(kept_.trouble(), revision()));
    if (!document_) return;
    pages_.send(request.client, document_event(*document_->now(), document_->status()));
    view_.send_beams(request.client);
    making_.send(request.client);
    designs_.send(request.client);
    send_solution(request.client);
    errors_.send(request.client);
}

void Studio::Impl::warn(const std::string& text) {
    pages_.broadcast(warning_event(text, revision()));
}

void Studio::Impl::show_fields(const Request& request) {
    request.json.allow_only({"id", "do", "fields"});
    pages_.show(request.client, read_beam_fields(request.json.at("fields")));
    pages_.answer(request);
    if (document_) send_solution(request.client);
}

void Studio::Impl::send_solution(ClientId client) {
    if (!view_.send_solution(client)) solve_live();
}

Document& Studio::Impl::document() {
    if (!document_) throw base::InputError("there is no document yet: open one, or make a new one");
    return *document_;
}

void Studio::Impl::undo(const Request& request) {
    request.json.allow_only({"id", "do"});
    const StatePtr before = document().now();
    if (!document_->undo()) throw base::InputError("there is nothing to undo");
    pages_.answer(request);
    follow_change(*before);
}

void Studio::Impl::redo(const Request& request) {
    request.json.allow_only({"id", "do"});
    const StatePtr before = document().now();
    if (!document_->redo()) throw base::InputError("there is nothing to redo");
    pages_.answer(request);
    follow_change(*before);
}

void Studio::Impl::select_load_case(const Request& request) {
    request.json.allow_only({"id", "do", "index"});
    const std::size_t cases = document().now()->load_cases->size();
    if (cases == 0) throw base::InputError("there is no load case to select");
    const auto index = request.json.at("index").integer(0, static_cast<long long>(cases) - 1);
    document_->select_load_case(index);
    pages_.answer(request);
    follow_change(*document_->now());
}

void Studio::Impl::replace(const Request& request, Opened next) {
    const auto discard = request.json.find("discard");
    if (document_ && discard && discard->boolean()) kept_.forget();
    show(std::move(next));
}

void Studio::Impl::show(Opened next) {
    document_ = std::move(next.document);
    kept_.take_place(std::move(next.place), document_->path());
    view_.begin(document_->revision());
    making_.begin();
    errors_.begin();
    designs_.forget();
    refuse_waiting_exports("another document took the place of the one to be exported");
    pages_.broadcast(document_event(*document_->now(), document_->status()));
    solve_live();
    kept_.keep(*document_);
}

void Studio::Impl::follow_change(const State& before) {
    designs_.follow(document_->now());
    kept_.keep(*document_);
    pages_.broadcast(changed_event(before, *document_->now(), document_->status()));
    making_.follow(before);
    solve_live();
}

void Studio::Impl::solve_live() {
    SolverInput input = document_->solver_input();
    input.fields = pages_.shown_fields();
    solver_.submit(std::move(input));
}

SolverListener Studio::Impl::listener() {
    const auto post_shown = [this](std::int64_t revision, auto take) {
        server_.post([this, revision, take] {
            if (view_.is_shown(revision)) take();
        });
    };
    return {.beams =
                [this, post_shown](const ShownBeams& shown) {
                    post_shown(shown.revision, [this, shown] { view_.take_beams(shown); });
                },
            .solved =
                [this, post_shown](const SolvedPtr& solved) {
                    post_shown(solved->revision, [this, solved] { take_solution(solved); });
                },
            .failed =
                [this, post_shown](const SolverInput& input, const std::string& error) {
                    post_shown(input.revision, [this, input, error] { take_failure(input, error); });
                },
            .progress =
                [this](const SolverInput& input, double share) {
                    server_.post([this, input, share] { view_.take_progress(input, share); });
                }};
}

void Studio::Impl::take_solution(const SolvedPtr& solved) {
    view_.take_solution(solved);
    if (solved->stage == Stage::FirstIterate) return;
    making_.look_at(*document_);
    errors_.look_at(solved);
    resume_exports();
    // This solve began when no page showed a field. Pages that show one now need a solve with forces.
    if (pages_.shown_fields().any() && solved->state.forces.rows() == 0) solve_live();
}

void Studio::Impl::take_failure(const SolverInput& input, const std::string& error) {
    view_.take_failure(input, error);
    resume_exports();
    making_.look_at(*document_);
}

}  // namespace fretwork::studio

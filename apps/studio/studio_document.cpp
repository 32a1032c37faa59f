// SPDX-License-Identifier: GPL-3.0-or-later
// The document, and what pages are shown of it.
#include "examples.hpp"
#include "frames.hpp"
#include "studio_impl.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/provenance.hpp>
#include <fretwork/reduction/tile_model.hpp>

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
    return list;
}

Json examples_json() {
    Json list = Json::array();
    for (const Example& example : examples())
        list.push_back(
            {{"name", example.name}, {"title", example.title}, {"description", example.description}});
    return list;
}

}  // namespace

Outgoing solved_message(const SolvedSurface& solved, const Json& more) {
    const mechanics::Solution& solution = solved.result.solution;
    const double largest = solution.displacements.rows() == 0
                               ? 0.0
                               : solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
    Json event = {{"event", "solved"},
                  {"revision", solved.revision},
                  {"model", solved.model},
                  {"seconds", solved.result.seconds},
                  {"solver", solved.result.solver},
                  {"converged", solution.converged()},
                  {"residual", solution.residual},
                  {"iterations", solution.iterations},
                  {"stable", solution.stable},
                  {"load_factor", solution.load_factor},
                  {"warnings", solved.warnings},
                  {"largest_displacement", largest},
                  {"fields", simulation::kBeamFields}};
    std::string positions = solution_message(solved.state, {solved.revision, solved.beams_revision});
    if (!more.is_null()) event.update(more);
    return {{text_part(event.dump()), binary_part(std::move(positions))}, more.is_null() ? "solution" : ""};
}

void Studio::Impl::hello(const Request& request) {
    request.json.allow_only({"id", "do", "protocol"});
    if (request.json.at("protocol").integer(0, 1000) != kProtocol)
        request.json.at("protocol")
            .fail("this server speaks protocol " + std::to_string(kProtocol) + "; load the page again");
    answer(request, {{"version", base::version()},
                     {"models", models_json()},
                     {"examples", examples_json()},
                     {"layouts", pattern::layout_names()},
                     {"has_library", document_ && !document_->now()->library->path.empty()},
                     {"has_document", document_.has_value()},
                     {"can_recover", !document_ && std::filesystem::exists(autosave_place_->file())}});
    clients_.insert(request.client);
    if (!document_) return;
    server_.send(request.client,
                 {{text_part(document_event(*document_->now(), document_->status()).dump())}});
    server_.send(request.client, beams_);
    server_.send(request.client, solved_);
}

Document& Studio::Impl::document(const Request&) {
    if (!document_) throw base::InputError("there is no document yet: open one, or make a new one");
    return *document_;
}

void Studio::Impl::undo(const Request& request) {
    request.json.allow_only({"id", "do"});
    const StatePtr before = document(request).now();
    if (!document_->undo()) throw base::InputError("there is nothing to undo");
    answer(request);
    tell_change(*before);
}

void Studio::Impl::redo(const Request& request) {
    request.json.allow_only({"id", "do"});
    const StatePtr before = document(request).now();
    if (!document_->redo()) throw base::InputError("there is nothing to redo");
    answer(request);
    tell_change(*before);
}

void Studio::Impl::select_load_case(const Request& request) {
    request.json.allow_only({"id", "do", "index"});
    const std::size_t cases = document(request).now()->load_cases->size();
    if (cases == 0) throw base::InputError("there is no load case to select");
    const auto index = request.json.at("index").integer(0, static_cast<long long>(cases) - 1);
    document_->select_load_case(static_cast<std::size_t>(index));
    answer(request);
    tell_change(*document_->now());
}

void Studio::Impl::show(Document next) {
    document_ = std::move(next);
    first_revision_ = document_->revision();
    take_place(document_->path());
    beams_ = {};
    solved_ = {};
    last_solved_.reset();
    last_beams_.reset();
    broadcast(document_event(*document_->now(), document_->status()));
    solve_live();
    keep();
}

void Studio::Impl::take_place(const std::optional<std::filesystem::path>& path) {
    if (autosave_place_ && place_is_of_ == path) return;
    autosave_place_.reset();  // its lock first
    autosave_place_.emplace(options_.state_folder, path);
    place_is_of_ = path;
}

void Studio::Impl::keep() {
    if (document_->is_saved())
        autosave_.forget(autosave_place_->file());
    else
        autosave_.keep(document_->now(), autosave_place_->file());
}

void Studio::Impl::tell_change(const State& before) {
    keep();
    broadcast(changed_event(before, *document_->now(), document_->status()));
    solve_live();
}

void Studio::Impl::solve_live() {
    solver_.submit(document_->solver_input());
}

SolverListener Studio::Impl::listener() {
    return {.beams = [this](const ShownBeams& shown) { server_.post([this, shown] { tell_beams(shown); }); },
            .solved = [this](SolvedPtr solved) { server_.post([this, solved] { tell_solved(solved); }); },
            .failed =
                [this](const SolverInput& input, const std::string& error) {
                    server_.post([this, input, error] { tell_failed(input, error); });
                },
            .told =
                [this](const SolverInput& input, double share) {
                    server_.post([this, input, share] {
                        broadcast(Json{{"event", "solving"},
                                       {"revision", input.revision},
                                       {"model", *input.situation.state->model},
                                       {"share", share}});
                    });
                }};
}

bool Studio::Impl::is_shown(std::int64_t revision) const {
    return document_ && revision >= first_revision_;
}

void Studio::Impl::tell_beams(const ShownBeams& shown) {
    if (!is_shown(shown.revision)) return;
    last_beams_ = shown;
    beams_ = {{binary_part(beams_message(*shown.beams, {shown.revision, shown.revision}))}};
    solved_ = {};
    broadcast(beams_);
}

void Studio::Impl::tell_solved(const SolvedPtr& solved) {
    if (!is_shown(solved->revision)) return;
    last_solved_ = solved;
    solved_ = solved_message(*solved);
    broadcast(solved_);
}

void Studio::Impl::tell_failed(const SolverInput& input, const std::string& error) {
    if (!is_shown(input.revision)) return;
    last_solved_.reset();
    const Json event = {{"event", "failed"},
                        {"revision", input.revision},
                        {"model", *input.situation.state->model},
                        {"error", error}};
    solved_ = {{text_part(event.dump())}, "solution"};
    broadcast(solved_);
}

}  // namespace fretwork::studio

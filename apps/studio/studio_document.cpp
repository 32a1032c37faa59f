// SPDX-License-Identifier: GPL-3.0-or-later
// The document, and what pages are shown of it.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/writer_catalogue.hpp>
#include <fretwork/fabrication/facts.hpp>
#include <fretwork/reduction/models/tile_model.hpp>
#include <studio/document/examples.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/server/words.hpp>
#include <studio/solving/making_doubts.hpp>
#include <studio/studio_impl.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

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
         {"summary", "corotational tiles, and every beam in a share of them: in those where that is worst"},
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

/// The kinds of file that `fretwork export` writes, by what each ending means.
Json exports_json() {
    Json list = Json::array();
    for (const exports::WriterRow& writer : exports::writer_catalogue()) {
        if (exports::is_default(writer))
            list.push_back({{"ending", writer.ending}, {"summary", writer.description}});
    }
    return list;
}

/// For each interface node that is held, what holds it.
Json reactions_json(const mechanics::Solution& solution, std::size_t interface_nodes) {
    Json rows = Json::array();
    const auto count = std::min(static_cast<Eigen::Index>(interface_nodes), solution.reactions.rows());
    for (Eigen::Index node = 0; node < count; ++node) {
        const auto row = solution.reactions.row(node);
        if (row.isZero(0.0)) continue;
        rows.push_back(
            {{"node", node}, {"force", {row[0], row[1], row[2]}}, {"moment", {row[3], row[4], row[5]}}});
    }
    return rows;
}

}  // namespace

Outgoing solved_message(const SolvedSurface& solved, const BeamFields& fields, const Json& more) {
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
                  {"stable", is_unchecked(solved.result) ? Json() : Json(solution.stable)},
                  {"load_factor", solution.load_factor},
                  {"warnings", solved.warnings},
                  {"largest_displacement", largest},
                  {"reactions", reactions_json(solution, solved.beams->interface_nodes)},
                  {"fields", solved.state.forces.rows() > 0 ? names_of(fields) : std::vector<std::string>{}}};
    std::string positions = solution_message(solved.state, {solved.revision, solved.beams_revision}, fields);
    if (solved.stage == Stage::FirstIterate) event["provisional"] = true;
    if (!more.is_null()) event.update(more);
    return {{text_part(event.dump()), binary_part(std::move(positions))}, more.is_null() ? "solution" : ""};
}

void Studio::Impl::hello(const Request& request) {
    request.json.allow_only({"id", "do", "protocol", "fields"});
    if (request.json.at("protocol").integer(0, 1000) != kProtocol)
        request.json.at("protocol")
            .fail("this server speaks protocol " + std::to_string(kProtocol) + "; load the page again");
    const auto fields = request.json.find("fields");
    clients_[request.client] = fields ? read_beam_fields(*fields) : kAllBeamFields;
    answer(request, {{"version", base::version()},
                     {"models", models_json()},
                     {"examples", examples_json()},
                     {"layouts", pattern::layout_names()},
                     {"has_library", document_ && !document_->now()->library->path.empty()},
                     {"has_document", document_.has_value()},
                     {"exports", exports_json()},
                     {"recoverable", recoverable_json()}});
    if (!no_autosave_.empty())
        server_.send(request.client,
                     {{text_part(Json{{"event", "warning"}, {"text", no_autosave_}}.dump())}});
    if (!document_) return;
    server_.send(request.client,
                 {{text_part(document_event(*document_->now(), document_->status()).dump())}});
    server_.send(request.client, beams_);
    server_.send(request.client, making_);
    send_solution(request.client);
}

void Studio::Impl::show_fields(const Request& request) {
    request.json.allow_only({"id", "do", "fields"});
    clients_[request.client] = read_beam_fields(request.json.at("fields"));
    answer(request);
    if (document_) send_solution(request.client);
}

BeamFields Studio::Impl::shown_fields() const {
    BeamFields shown;
    for (const auto& [client, fields] : clients_) shown |= fields;
    return shown;
}

void Studio::Impl::send_solution(ClientId client) {
    const BeamFields& fields = clients_.at(client);
    if (!last_solved_)
        server_.send(client, failed_);
    else if (fields.none() || last_solved_->state.forces.rows() > 0)
        server_.send(client, solved_message(*last_solved_, fields));
    else
        solve_live();
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

void Studio::Impl::replace(const Request& request, Opened next) {
    const auto discard = request.json.find("discard");
    if (document_ && discard && discard->boolean()) forget_kept();
    show(std::move(next));
}

void Studio::Impl::show(Opened next) {
    document_ = std::move(next.document);
    first_revision_ = document_->revision();
    autosave_place_ = next.place ? std::move(next.place) : place_for(document_->path());
    beams_ = {};
    failed_ = {};
    last_solved_.reset();
    last_failure_.reset();
    last_beams_.reset();
    checked_.reset();
    making_ = {};
    refuse_waiting_exports("another document took the place of the one to be exported");
    broadcast(document_event(*document_->now(), document_->status()));
    solve_live();
    keep();
}

void Studio::Impl::keep() {
    if (!autosave_place_) return;
    if (document_->is_saved())
        forget_kept();
    else
        autosave_.keep(document_->now(), {document_->status().name, document_->path()},
                       autosave_place_->file());
}

void Studio::Impl::tell_change(const State& before) {
    keep();
    broadcast(changed_event(before, *document_->now(), document_->status()));
    solve_live();
}

void Studio::Impl::solve_live() {
    SolverInput input = document_->solver_input();
    input.fields = shown_fields();
    solver_.submit(std::move(input));
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
    failed_ = {};
    last_solved_.reset();
    broadcast(beams_);
}

void Studio::Impl::tell_solved(const SolvedPtr& solved) {
    if (!is_shown(solved->revision)) return;
    if (solved->stage == Stage::Answer) last_solved_ = solved;
    std::map<unsigned long, Outgoing> messages;  // pages that show the same get the same bytes
    const bool has_forces = solved->state.forces.rows() > 0;
    for (const auto& [client, fields] : std::map(clients_)) {
        if (fields.any() && !has_forces) continue;
        Outgoing& message = messages[fields.to_ulong()];
        if (message.parts.empty()) message = solved_message(*solved, fields);
        server_.send(client, message);
    }
    if (solved->stage == Stage::FirstIterate) return;
    check_making();
    resume_exports();
    // It was begun when nobody showed any field: those who do wait for them.
    if (shown_fields().any() && !has_forces) solve_live();
}

void Studio::Impl::tell_failed(const SolverInput& input, const std::string& error) {
    if (!is_shown(input.revision)) return;
    last_solved_.reset();
    const Json event = {{"event", "failed"},
                        {"revision", input.revision},
                        {"model", *input.situation.state->model},
                        {"error", error}};
    failed_ = {{text_part(event.dump())}, "solution"};
    broadcast(failed_);
    last_failure_ = {input.situation, error};
    resume_exports();
    check_making();
}

namespace {

/// Whether the same bars lie in the same places.
bool is_made_alike(const State& one, const State& other) {
    return one.ground == other.ground && one.painting == other.painting && one.setting == other.setting;
}

/// Strokes and drags follow each other faster.
constexpr std::chrono::milliseconds kRest{300};
constexpr std::chrono::milliseconds kLook{10};

void rest(const base::Control& control) {
    for (auto waited = 0 * kLook; waited < kRest; waited += kLook) {
        control.check();
        std::this_thread::sleep_for(kLook);
    }
}

}  // namespace

void Studio::Impl::check_making() {
    const StatePtr state = document_->now();
    if (checked_ && is_made_alike(*checked_, *state)) return;
    checks_.cancel();
    checked_ = state;
    making_ = {};
    if (std::ranges::any_of(state->painting->patterns, [](int pattern) { return pattern < 0; })) return;
    const std::int64_t revision = document_->revision();
    checks_.add({.work =
                     [this, state, revision](const base::Control& control) {
                         rest(control);
                         const MakingDoubts doubts =
                             making_doubts(open_surface(*state).surface, {.control = control},
                                           fabrication::FactsOptions().clearance);
                         server_.post([this, state, event = making_event(doubts, revision)] {
                             tell_making(state, event);
                         });
                     },
                 // The live solution already reports what cannot be built.
                 .failed = [](const std::string&) {}});
}

void Studio::Impl::tell_making(const StatePtr& state, const Json& event) {
    if (!document_ || checked_ != state || !is_made_alike(*state, *document_->now())) return;
    making_ = {{text_part(event.dump())}};
    broadcast(making_);
}

}  // namespace fretwork::studio

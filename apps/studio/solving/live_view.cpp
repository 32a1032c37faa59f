// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/simulation/results/model_doubt.hpp>
#include <studio/server/binary_messages.hpp>
#include <studio/solving/live_view.hpp>

#include <algorithm>
#include <utility>

namespace fretwork::studio {

using base::Json;

namespace {

/// The reactions at each interface node that is held.
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

bool has_forces(const SolvedSurface& solved) {
    return solved.state.forces.rows() > 0;
}

}  // namespace

Outgoing solved_message(const SolvedSurface& solved, const BeamFields& fields, const Json& more) {
    const mechanics::Solution& solution = solved.result.solution;
    const double largest = solution.displacements.rows() == 0
                               ? 0.0
                               : solution.displacements.leftCols<3>().rowwise().norm().maxCoeff();
    Json event = {
        {"event", "solved"},
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
        {"doubtful", solved.result.model_doubt ? Json(simulation::is_doubtful(solved.result)) : Json()},
        {"largest_displacement", largest},
        {"reactions", reactions_json(solution, solved.beams->interface_nodes)},
        {"fields", has_forces(solved) ? names_of(fields) : std::vector<std::string>{}}};
    std::string positions = solution_message(solved.state, {solved.revision, solved.beams_revision}, fields);
    if (solved.stage == Stage::FirstIterate) event["provisional"] = true;
    if (!more.is_null()) event.update(more);
    return {{json_part(event), binary_part(std::move(positions))}, more.is_null() ? "solution" : ""};
}

void LiveView::begin(std::int64_t first_revision) {
    first_revision_ = first_revision;
    last_beams_.reset();
    beams_message_ = {};
    last_solved_.reset();
    failure_message_ = {};
    last_failure_.reset();
}

void LiveView::take_beams(const ShownBeams& shown) {
    last_beams_ = shown;
    beams_message_ = {{binary_part(beams_message(*shown.beams, {shown.revision, shown.revision}))}};
    last_solved_.reset();
    failure_message_ = {};
    pages_.broadcast(beams_message_);
}

void LiveView::take_solution(const SolvedPtr& solved) {
    if (solved->stage == Stage::Answer) last_solved_ = solved;
    pages_.broadcast([&](const BeamFields& fields) {
        return fields.any() && !has_forces(*solved) ? Outgoing{} : solved_message(*solved, fields);
    });
}

void LiveView::take_failure(const SolverInput& input, const std::string& error) {
    last_solved_.reset();
    const Json event = {{"event", "failed"},
                        {"revision", input.revision},
                        {"model", *input.situation.state->model},
                        {"error", error}};
    failure_message_ = {{json_part(event)}, "solution"};
    pages_.broadcast(failure_message_);
    last_failure_ = {input.situation, error};
}

void LiveView::take_progress(const SolverInput& input, double share) {
    pages_.broadcast(Json{{"event", "solving"},
                          {"revision", input.revision},
                          {"model", *input.situation.state->model},
                          {"share", share}});
}

bool LiveView::send_solution(ClientId client) {
    const BeamFields& fields = pages_.fields(client);
    if (!last_solved_)
        pages_.send(client, failure_message_);
    else if (fields.none() || has_forces(*last_solved_))
        pages_.send(client, solved_message(*last_solved_, fields));
    else
        return false;
    return true;
}

const ShownBeams* LiveView::beams_of(const State& state) const {
    return last_beams_ && last_beams_->painting == state.painting && last_beams_->ground == state.ground
               ? &*last_beams_
               : nullptr;
}

std::optional<AnswerToExport> LiveView::answer_to(const Situation& situation) const {
    if (situation.state->load_cases->empty()) return AnswerToExport{};
    if (last_solved_ && last_solved_->situation == situation) {
        if (last_solved_->result.solution.converged()) return AnswerToExport{last_solved_, ""};
        return AnswerToExport{nullptr, last_solved_->warnings.front()};
    }
    if (last_failure_ && last_failure_->situation == situation)
        return AnswerToExport{nullptr, last_failure_->reason};
    return std::nullopt;
}

}  // namespace fretwork::studio

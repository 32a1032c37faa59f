// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/library/detail/rows.hpp>

#include <algorithm>
#include <cmath>

namespace fretwork::library::detail {
namespace {

using reduction::Response;
using Sample = Response::Sample;

std::string count_complaint(std::size_t present, std::size_t wanted, const std::string& what) {
    return "has " + std::to_string(present) + " " + what + ", where " + std::to_string(wanted) +
           " are needed";
}

/// The way in which a response differs from the library's shape; empty if it agrees.
std::string response_fault(const Response& response, const ResponseShape& shape) {
    const std::size_t steps = shape.setting->magnitudes;
    if (response.samples.size() != steps) return count_complaint(response.samples.size(), steps, "samples");
    for (std::size_t k = 0; k < steps; ++k) {
        const Sample& sample = response.samples[k];
        if (sample.step != static_cast<int>(k) + 1)
            return "has step " + std::to_string(sample.step) + " in place " + std::to_string(k + 1);
        if (!sample.converged) continue;
        if (sample.displacements.rows() != shape.nodes)
            return count_complaint(sample.displacements.rows(), shape.nodes, "rows of displacements");
    }
    return "";
}

bool is_finite(const Sample& sample) {
    return std::isfinite(sample.magnitude) && std::isfinite(sample.discretization_error.value_or(0.0)) &&
           (!sample.converged || sample.displacements.allFinite());
}

void insert_sample(Statement& states, Statement& rows, const Sample& sample, std::string_view pattern_id,
                   const std::string& scenario) {
    states
        .bind_all(pattern_id, scenario, sample.step, sample.magnitude, int{sample.converged},
                  int{sample.stable}, int{sample.limit_load}, sample.discretization_error)
        .run();
    if (!sample.converged) return;
    for (int node = 0; node < static_cast<int>(sample.displacements.rows()); ++node) {
        const auto d = sample.displacements.row(node);
        rows.bind_all(pattern_id, scenario, sample.step, node, d[0], d[1], d[2], d[3], d[4], d[5]).run();
    }
}

constexpr std::string_view kStates =
    "SELECT scenario, step, magnitude, converged, stable, limit_load, discretization_error "
    "FROM response_state WHERE pattern_id = ? ORDER BY scenario, step";
constexpr std::string_view kDisplacements =
    "SELECT scenario, step, node, ux, uy, uz, rx, ry, rz FROM response WHERE pattern_id = ? "
    "ORDER BY scenario, step, node";

/// Finds the response of the scenario that a row names; null if the setting has no such scenario. Consecutive
/// rows of one scenario need one search.
class CurrentResponse {
  public:
    explicit CurrentResponse(std::vector<Response>& responses) : responses_(responses) {}
    Response* of(std::string_view scenario) {
        if (response_ == nullptr || response_->scenario != scenario) {
            const auto found = std::ranges::find(responses_, scenario, &Response::scenario);
            response_ = found == responses_.end() ? nullptr : &*found;
        }
        return response_;
    }

  private:
    std::vector<Response>& responses_;
    Response* response_ = nullptr;
};

bool are_equal(const Sample& left, const Sample& right) {
    return left.step == right.step && left.magnitude == right.magnitude &&
           left.converged == right.converged && left.stable == right.stable &&
           left.limit_load == right.limit_load && left.discretization_error == right.discretization_error &&
           (!left.converged || left.displacements == right.displacements);
}

}  // namespace

void check_responses(const Database& database, const std::string& pattern_id,
                     const std::vector<Response>& responses, const ResponseShape& shape) {
    const std::string file = database.path().string();
    const auto& scenarios = shape.setting->scenarios;
    if (responses.size() != scenarios.size())
        throw base::InputError(file, "pattern " + pattern_id,
                               count_complaint(responses.size(), scenarios.size(), "responses"));
    for (std::size_t k = 0; k < scenarios.size(); ++k) {
        const Response& response = responses[k];
        const std::string place = "pattern " + pattern_id + ", scenario " + response.scenario;
        if (response.scenario != scenarios[k].name)
            throw base::InputError(file, place, "stands where the setting has " + scenarios[k].name);
        if (const std::string fault = response_fault(response, shape); !fault.empty())
            throw base::InputError(file, place, fault);
        if (!std::all_of(response.samples.begin(), response.samples.end(), is_finite))
            throw base::NumericalError(file + ": " + place +
                                       ": a magnitude, displacement or error is not finite");
    }
}

void insert_responses(const Database& database, const std::string& pattern_id,
                      const std::vector<Response>& responses) {
    Statement states(database, "INSERT INTO response_state VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
    Statement rows(database, "INSERT INTO response VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const Response& response : responses) {
        for (const Sample& sample : response.samples)
            insert_sample(states, rows, sample, pattern_id, response.scenario);
    }
}

ResponseReader::ResponseReader(const Database& database, const ResponseShape& shape)
    : database_(database),
      shape_(shape),
      states_(database, kStates),
      displacements_(database, kDisplacements) {}

std::vector<Response> ResponseReader::read(std::string_view pattern_id) {
    std::vector<Response> responses;
    for (const reduction::Scenario& scenario : shape_.setting->scenarios)
        responses.push_back({scenario.name, {}});
    read_states(pattern_id, responses);
    read_displacements(pattern_id, responses);
    std::erase_if(responses, [](const Response& response) { return response.samples.empty(); });
    return responses;
}

void ResponseReader::read_states(std::string_view pattern_id, std::vector<Response>& responses) {
    CurrentResponse current(responses);
    states_.bind_all(pattern_id);
    while (states_.step()) {
        Response* response = current.of(states_.text(0));
        if (response == nullptr) continue;
        response->samples.push_back({states_.count(1), states_.real(2),
                                     mechanics::NodeValues::Zero(shape_.nodes, mechanics::kDofsPerNode),
                                     states_.integer(3) != 0, states_.integer(4) != 0,
                                     states_.integer(5) != 0, states_.optional_real(6)});
    }
}

void ResponseReader::read_displacements(std::string_view pattern_id, std::vector<Response>& responses) {
    CurrentResponse current(responses);
    displacements_.bind_all(pattern_id);
    while (displacements_.step()) {
        Response* response = current.of(displacements_.text(0));
        if (response == nullptr) continue;
        const std::size_t step = displacements_.integer(1);
        const std::int64_t node = displacements_.integer(2);
        if (step < 1 || step > response->samples.size() || node < 0 || node >= shape_.nodes) {
            throw base::InputError(database_.path().string(), "response of " + std::string(pattern_id),
                                   "has a row of step " + std::to_string(step) + ", node " +
                                       std::to_string(node) + ", which its setting does not have");
        }
        auto row = response->samples[step - 1].displacements.row(node);
        for (int dof = 0; dof < mechanics::kDofsPerNode; ++dof) row[dof] = displacements_.real(3 + dof);
    }
}

bool are_equal(const std::vector<Response>& left, const std::vector<Response>& right) {
    const auto same_samples = [](const Sample& a, const Sample& b) { return are_equal(a, b); };
    const auto same = [&](const Response& a, const Response& b) {
        return a.scenario == b.scenario && std::ranges::equal(a.samples, b.samples, same_samples);
    };
    return std::ranges::equal(left, right, same);
}

}  // namespace fretwork::library::detail

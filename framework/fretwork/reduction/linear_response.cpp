// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/reduction/linear_response.hpp>

namespace fretwork::reduction {

std::vector<Response> linear_responses(const UnitDisplacements& model, const Setting& setting) {
    std::vector<Response> responses;
    for (std::size_t s = 0; s < setting.scenarios.size(); ++s) {
        Response& response = responses.emplace_back();
        response.scenario = setting.scenarios[s].name;
        for (int k = 1; k <= setting.magnitudes; ++k) {
            const double magnitude = setting.scenarios[s].max_magnitude * k / setting.magnitudes;
            response.samples.push_back(
                {.step = k, .magnitude = magnitude, .displacements = magnitude * model[s]});
        }
    }
    return responses;
}

}  // namespace fretwork::reduction

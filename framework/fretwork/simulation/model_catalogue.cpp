// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/model_catalogue.hpp>

#include <algorithm>
#include <array>

namespace fretwork::simulation {
namespace {

constexpr std::array<ModelRow, 3> kModels = {{
    {"full", "every beam of every pattern, geometrically nonlinear", true, build_full_model},
    {"paper6", "the paper's six-parameter reduced model, linear; needs a library with calibrations", false,
     build_paper6_model},
    {"condensed", "every tile condensed onto its interface nodes, linear", false, build_condensed_model},
}};

}  // namespace

std::span<const ModelRow> model_catalogue() {
    return kModels;
}

const ModelRow& find_model(std::string_view name) {
    const auto row = std::find_if(kModels.begin(), kModels.end(),
                                  [&](const ModelRow& model) { return model.name == name; });
    if (row != kModels.end()) return *row;
    std::vector<std::string> names;
    for (const ModelRow& model : kModels) names.emplace_back(model.name);
    throw base::InputError(base::unknown_name_message("model", name, names));
}

}  // namespace fretwork::simulation

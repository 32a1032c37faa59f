// SPDX-License-Identifier: GPL-3.0-or-later
#include "tables.hpp"

#include <fretwork/base/parallel.hpp>
#include <fretwork/reduction/calibration/calibration.hpp>
#include <fretwork/reduction/calibration/objective.hpp>
#include <fretwork/reduction/ring/ring_hexagon.hpp>

#include <cstdio>
#include <optional>

namespace fretwork::experiments {
namespace {

using reduction::Calibration;
using reduction::Objective;
using reduction::SamplePolicy;
using reduction::Setting;

/// One pattern, calibrated under both policies.
struct Pair {
    std::size_t left_out = 0;      ///< samples that only the paper's policy uses
    double paper = 0.0;            ///< E under the paper's policy
    double stable = 0.0;           ///< E under the stable one: a sum over fewer samples
    double paper_on_stable = 0.0;  ///< E of the paper policy's parameters on the stable samples
    double stable_on_paper = 0.0;  ///< and the other way round
};

Setting under(Setting setting, SamplePolicy policy) {
    setting.sample_policy = policy;
    return setting;
}

std::optional<Pair> compare(const pattern::NamedPattern& entry, const TableInput& input,
                            const std::vector<reduction::Response>& responses) {
    const Setting paper = under(input.library.setting(), SamplePolicy::Paper);
    const Setting stable = under(input.library.setting(), SamplePolicy::Stable);
    const Objective on_paper(responses, paper);
    const Objective on_stable(responses, stable);
    if (on_stable.sample_count() == 0) return std::nullopt;
    const reduction::TileModel& paper6 = reduction::find_tile_model("paper6");
    const auto fit = [&](const Setting& setting) {
        return calibrate(paper6, {input.library.layout(), entry.pattern, setting, responses}, input.options);
    };
    const Calibration a = fit(paper);
    const Calibration b = fit(stable);
    const auto parameters_of = [&](const Calibration& calibration) {
        return reduction::paper6_parameters().parts(parameter_values(calibration, paper6));
    };
    const reduction::RingHexagon model(paper);
    return Pair{on_paper.sample_count() - on_stable.sample_count(), a.objective, b.objective,
                on_stable.value(model.displacements(parameters_of(a))),
                on_paper.value(model.displacements(parameters_of(b)))};
}

void print_rows(const char* who, const std::vector<Pair>& pairs) {
    const auto of = [&](double Pair::*member) {
        std::vector<double> values;
        for (const Pair& pair : pairs) values.push_back(pair.*member);
        return distribution(std::move(values));
    };
    const auto row = [&](const char* policy, double Pair::*own, double Pair::*paper, double Pair::*stable) {
        const Distribution d = of(own);
        print_row({who, std::to_string(pairs.size()), policy, fixed(d.mean, 2), fixed(d.deviation, 2),
                   fixed(d.quantile(0.5), 2), fixed(of(paper).mean, 2), fixed(of(stable).mean, 2)});
    };
    row("paper", &Pair::paper, &Pair::paper, &Pair::paper_on_stable);
    row("stable", &Pair::stable, &Pair::stable_on_paper, &Pair::stable);
}

}  // namespace

void print_policies(const TableInput& input) {
    std::vector<std::vector<reduction::Response>> responses;
    std::vector<std::optional<Pair>> found(input.patterns.size());
    for (const auto& entry : input.patterns) responses.push_back(input.library.responses(entry.id));
    base::parallel_for(found.size(), input.threads,
                       [&](std::size_t i) { found[i] = compare(input.patterns[i], input, responses[i]); });
    std::vector<Pair> all;
    std::vector<Pair> changed;
    std::size_t left_out = 0;
    for (const auto& pair : found) {
        if (!pair) continue;
        all.push_back(*pair);
        left_out += pair->left_out;
        if (pair->left_out > 0) changed.push_back(*pair);
    }
    std::printf(
        "Samples past the first loss of stability: fitted (paper) or left out (stable: %zu samples)\n\n",
        left_out);
    print_head({"patterns", "number", "policy", "mean E", "deviation", "median", "mean E on all samples",
                "mean E on stable samples"});
    print_rows("all", all);
    if (!changed.empty()) print_rows("with such samples", changed);
    std::printf("\n");
}

}  // namespace fretwork::experiments

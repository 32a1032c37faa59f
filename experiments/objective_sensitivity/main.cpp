// SPDX-License-Identifier: GPL-3.0-or-later
// The changes if E were the mean over samples, or the weights of Table 2 were others: the paper's model
// fitted to the same responses by several objectives, all with Ceres. See README.md.
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/minimize.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/response.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace fretwork;
using reduction::ErrorMetric;
using reduction::Response;
using reduction::SamplePolicy;
using reduction::Setting;

struct Options {
    std::size_t patterns = 152;
    double load_factor = 1.0;
    int starts = 8;
    std::uint64_t seed = 1;
    int threads = 0;
    std::string out = "objective_sensitivity.csv";
};

/// An objective of the same form as the paper's.
struct Weights {
    Setting setting;  ///< its scenarios carry the weights w_k
    ErrorMetric metric{};
    std::uint64_t seed = 0;  ///< of the search
};

struct Variant {
    std::string name;
    std::function<void(Weights&, const std::vector<Response>&)> change;
};

/// As many samples as the objective counts: those that converged, up to the first unstable one where the
/// policy says so.
int counted_samples(const Response& response, SamplePolicy policy) {
    int count = 0;
    for (const Response::Sample& sample : response.samples) {
        if (policy == SamplePolicy::Stable && sample.converged && !sample.stable) break;
        count += sample.converged ? 1 : 0;
    }
    return count;
}

/// Each scenario's sum becomes a mean. All are multiplied by the number of magnitudes, which moves no
/// minimum.
void take_means(Weights& weights, const std::vector<Response>& responses) {
    for (std::size_t s = 0; s < responses.size(); ++s) {
        const int count = counted_samples(responses[s], weights.setting.sample_policy);
        if (count > 0)
            weights.setting.scenarios[s].weight *= weights.setting.magnitudes / static_cast<double>(count);
    }
}

std::vector<Variant> variants() {
    std::vector<Variant> result;
    const auto add = [&](std::string name, auto change) {
        result.push_back(
            {std::move(name), [change](Weights& w, const std::vector<Response>& r) { change(w, r); }});
    };
    using Responses = const std::vector<Response>&;
    add("as published", [](Weights&, Responses) {});
    add("another seed", [](Weights& w, Responses) { ++w.seed; });  // what the search itself leaves open
    add("mean over samples", take_means);
    add("stable samples", [](Weights& w, Responses) { w.setting.sample_policy = SamplePolicy::Stable; });
    add("mean over stable samples", [](Weights& w, Responses r) {
        w.setting.sample_policy = SamplePolicy::Stable;
        take_means(w, r);
    });
    add("equal weights", [](Weights& w, Responses) {
        for (auto& scenario : w.setting.scenarios) scenario.weight = 1.0;
    });
    for (std::size_t s = 0; s < reduction::paper_scenarios().size(); ++s)
        add("twice " + reduction::paper_scenarios()[s].name,
            [s](Weights& w, Responses) { w.setting.scenarios[s].weight *= 2.0; });
    add("translations and rotations alike",
        [](Weights& w, Responses) { w.metric.translation_weight = w.metric.rotation_weight = 1.0; });
    add("rotations before translations",
        [](Weights& w, Responses) { std::swap(w.metric.translation_weight, w.metric.rotation_weight); });
    add("thresholds a tenth", [](Weights& w, Responses) {
        w.metric.smallest_translation *= 0.1;
        w.metric.smallest_rotation *= 0.1;
    });
    return result;
}

/// The model of a pattern by one objective, beside that by the paper's.
struct Fit {
    std::vector<double> parameters;  ///< A, I2, I3, J, theta, R
    double paper_objective = 0.0;    ///< E as published
    std::vector<double> shift;  ///< by scenario: |u - u'| / |u'| over the interface nodes, u' the paper's
};

struct Examined {
    std::string id;
    int samples = 0;  ///< that E counts
    std::vector<Fit> fits;
};

double translation_shift(const mechanics::NodeValues& one, const mechanics::NodeValues& other) {
    return (one - other).leftCols<3>().norm() / other.leftCols<3>().norm();
}

class Examination {
  public:
    Examination(const std::vector<Response>& responses, const Setting& setting, const Options& options)
        : responses_(responses),
          setting_(setting),
          options_(options),
          model_(setting),
          published_(responses, setting) {}

    [[nodiscard]] std::vector<Fit> run() const {
        std::vector<Fit> fits;
        reduction::UnitDisplacements paper;
        for (const Variant& variant : variants()) {
            Weights weights{setting_, {}, options_.seed};
            variant.change(weights, responses_);
            const reduction::Objective objective(responses_, weights.setting, weights.metric);
            const reduction::RingProblem problem(model_, reduction::paper6_parameters(), objective, setting_);
            const auto report =
                optimization::minimize(problem, optimization::find_optimizer("ceres-multistart"),
                                       {.starts = options_.starts, .seed = weights.seed});
            const auto displacements = problem.displacements(report.point);
            if (fits.empty()) paper = displacements;
            Fit& fit = fits.emplace_back();
            fit.parameters = problem.parameter_values(report.point);
            fit.paper_objective = published_.value(displacements);
            for (std::size_t s = 0; s < paper.size(); ++s)
                fit.shift.push_back(translation_shift(displacements[s], paper[s]));
        }
        return fits;
    }
    [[nodiscard]] int samples() const { return static_cast<int>(published_.sample_count()); }

  private:
    const std::vector<Response>& responses_;
    const Setting& setting_;
    const Options& options_;
    reduction::RingHexagon model_;
    reduction::Objective published_;
};

std::vector<Examined> examine_sample(const Options& options) {
    const auto layout = pattern::find_node_layout("paper7");
    const auto all =
        pattern::enumerate_patterns(layout, {.edges = pattern::default_edge_range(layout), .filters = {}});
    const auto chosen = reduction::spread_over_edges(all, options.patterns);
    Setting setting = reduction::paper_setting();
    for (auto& scenario : setting.scenarios) scenario.max_magnitude *= options.load_factor;
    std::vector<Examined> results(chosen.size());
    base::parallel_for(chosen.size(), options.threads, [&](std::size_t i) {
        const auto& pattern = chosen[i];
        const auto responses = reduction::compute_responses(layout, pattern, setting);
        const Examination examination(responses, setting, options);
        results[i] = {pattern::pattern_id(layout, pattern), examination.samples(), examination.run()};
    });
    return results;
}

std::string csv(const std::vector<Examined>& results) {
    std::string text = "pattern,samples,objective,paper_E,A,I2,I3,J,theta,R";
    for (const auto& scenario : reduction::paper_scenarios()) text += ",shift_" + scenario.name;
    text += "\n";
    const auto names = variants();
    for (const Examined& result : results) {
        for (std::size_t v = 0; v < names.size(); ++v) {
            const Fit& fit = result.fits[v];
            text += result.id + "," + std::to_string(result.samples) + "," + names[v].name + "," +
                    base::format_number(fit.paper_objective);
            for (const double value : fit.parameters) text += "," + base::format_number(value);
            for (const double value : fit.shift) text += "," + base::format_number(value);
            text += "\n";
        }
    }
    return text;
}

double quantile(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

/// One number of each pattern for a variant.
std::vector<double> over_patterns(const std::vector<Examined>& results,
                                  const std::function<double(const Examined&)>& value) {
    std::vector<double> values;
    for (const Examined& result : results) values.push_back(value(result));
    return values;
}

void print_row(const std::vector<Examined>& results, std::size_t v, const std::string& name) {
    const auto of = [&](const std::function<double(const Fit&, const Fit&)>& value, double share) {
        return quantile(
            over_patterns(results, [&](const Examined& e) { return value(e.fits[v], e.fits[0]); }), share);
    };
    const auto excess = [](const Fit& fit, const Fit& paper) {
        return fit.paper_objective / paper.paper_objective - 1.0;
    };
    const auto section = [](const Fit& fit, const Fit& paper) {
        double largest = 0.0;
        for (std::size_t p = 0; p < 4; ++p)
            largest = std::max(largest, std::abs(std::log(fit.parameters[p] / paper.parameters[p])));
        return std::exp(largest);
    };
    const auto turn = [](const Fit& fit, const Fit& paper) {
        return std::abs(fit.parameters[4] - paper.parameters[4]) * 180.0 / std::numbers::pi;
    };
    const auto shift = [](const Fit& fit, const Fit&) { return *std::ranges::max_element(fit.shift); };
    std::printf("| %s | %.2g / %.2g | %.3g / %.3g | %.2g / %.2g | %.2g / %.2g |\n", name.c_str(),
                100 * of(excess, 0.5), 100 * of(excess, 0.9), of(section, 0.5), of(section, 0.9),
                of(turn, 0.5), of(turn, 0.9), 100 * of(shift, 0.5), 100 * of(shift, 0.9));
}

void print_table(const std::vector<Examined>& results) {
    const auto left_out = std::ranges::count_if(results, [](const Examined& e) { return e.samples < 50; });
    std::printf("%zu patterns, %td of them with samples that did not converge. Median / ninth tenth:\n\n",
                results.size(), left_out);
    std::printf(
        "| objective | E as published rises by, %% | largest factor of a section | theta moves, deg | "
        "displacements move, %% |\n"
        "|---|---|---|---|---|\n");
    const auto names = variants();
    for (std::size_t v = 1; v < names.size(); ++v) print_row(results, v, names[v].name);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Fit the paper's model by other objectives than the paper's, and tell what changes.");
    app.add_option("--patterns", options.patterns, "How many, spread over the numbers of edges")
        ->capture_default_str();
    app.add_option("--load-factor", options.load_factor, "Times the paper setting's largest magnitudes")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--starts", options.starts, "Of each calibration")->capture_default_str();
    app.add_option("--seed", options.seed, "Of each calibration")->capture_default_str();
    app.add_option("--threads", options.threads, "Threads; 0: all there are")->capture_default_str();
    app.add_option("--out", options.out, "The CSV file to write")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        const auto results = examine_sample(options);
        base::write_file_atomically(options.out, csv(results));
        print_table(results);
    } catch (const base::Error& error) {
        std::fprintf(stderr, "objective_sensitivity: %s\n", error.what());
        return 2;
    }
    return 0;
}

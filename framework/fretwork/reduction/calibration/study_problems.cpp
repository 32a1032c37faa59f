// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/random.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/calibration/study_problems.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/linear_response.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>
#include <fretwork/reduction/stratified_sample.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace fretwork::reduction {
namespace {

using optimization::study::ProblemFamilies;
using optimization::study::StudyProblem;

constexpr int kSyntheticProblems = 12;
/// The scale of synthetic problems, whose lowest objective is 0. A good fit to a pattern has an objective of
/// the order of 1.
constexpr double kUnitOfCalibrations = 1.0;

/// The paper's problem together with the data to which it refers.
class OwnedProblem final {
  public:
    OwnedProblem(const std::vector<Response>& responses, const Setting& setting)
        : model_(setting),
          objective_(responses, setting),
          problem_(model_, paper6_parameters(), objective_, setting) {}
    OwnedProblem(const OwnedProblem&) = delete;
    OwnedProblem& operator=(const OwnedProblem&) = delete;
    [[nodiscard]] const RingProblem& problem() const { return problem_; }

  private:
    RingHexagon model_;
    Objective objective_;
    RingProblem problem_;
};

std::shared_ptr<const RingProblem> make_calibration(const std::vector<Response>& responses,
                                                    const Setting& setting) {
    const auto owner = std::make_shared<const OwnedProblem>(responses, setting);
    return {owner, &owner->problem()};
}

/// The layout named before a pattern's id; the paper's layout if none is named.
pattern::NodeLayout layout_of(const std::string& pattern_id) {
    const auto colon = pattern_id.find(':');
    return colon == std::string::npos ? pattern::paper_layout()
                                      : pattern::find_node_layout(pattern_id.substr(0, colon));
}

/// The setting named after the '@' of an id; without '@', the paper's.
Setting setting_of(const std::string& id, const std::string& name,
                   const std::vector<NamedSetting>& settings) {
    const auto at = name.find('@');
    if (at == std::string::npos) return paper_setting();
    const auto named = std::ranges::find(settings, name.substr(at + 1), &NamedSetting::name);
    if (named == settings.end())
        throw base::InputError("'" + id + "' is a problem in a setting '" + name.substr(at + 1) +
                               "', which is not given");
    return named->setting;
}

StudyProblem calibration_problem(const std::string& id, const std::string& name,
                                 const std::vector<NamedSetting>& settings) {
    const auto setting = setting_of(id, name, settings);
    const std::string pattern_id = name.substr(0, name.find('@'));
    const auto layout = layout_of(pattern_id);
    const auto pattern = pattern::parse_pattern_id(layout, pattern_id);
    if (!RingHexagon::fits(layout, setting))
        throw base::InputError(
            "'" + id + "': a problem needs a hexagon and one interface node a side; layout '" +
            layout.name() + "' has " + std::to_string(layout.interface_nodes().size()) +
            " a side, and the setting's polygon has " + std::to_string(setting.sides) + " sides");
    const auto responses = compute_responses(layout, pattern, setting);
    return {id, make_calibration(responses, setting), std::nullopt, {}, {}};
}

StudyProblem synthetic_problem(const std::string& id, const std::string& number) {
    const int n = base::read_number<int>(number).value_or(0);
    if (n < 1 || number != std::to_string(n))  // each problem has a single id
        throw base::InputError("'" + id + "' is not a synthetic problem, such as synthetic/1");
    const auto setting = paper_setting();
    const auto any = make_calibration(
        linear_responses(
            UnitDisplacements(setting.scenarios.size(), mechanics::NodeValues::Ones(setting.sides, 6)),
            setting),
        setting);
    base::RandomStream random(static_cast<std::uint64_t>(n), 0);
    Eigen::VectorXd shares(any->bounds().dimension());
    for (double& share : shares) share = 0.1 + 0.8 * random.uniform();
    const Eigen::VectorXd optimum = any->bounds().at_shares(shares);
    const auto target = linear_responses(any->displacements(optimum), setting);
    return {id, make_calibration(target, setting), 0.0, optimum, kUnitOfCalibrations};
}

/// The third of the ranks 0..count-1 in which a rank lies.
int third_of(std::size_t rank, std::size_t count) {
    return static_cast<int>(3 * rank / count);
}

/// The stratum of each pattern. Patterns with the same number of edges form three strata of about equal size:
/// the softest, the middle and the stiffest in bending.
std::vector<int> strata_of(const std::vector<pattern::Pattern>& patterns) {
    const auto setting = paper_setting();
    std::map<int, std::vector<std::pair<double, std::size_t>>> by_edges;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const auto plate = effective_properties(pattern::paper_layout(), patterns[i], setting);
        by_edges[patterns[i].edge_count()].emplace_back(plate.D.trace(), i);
    }
    std::vector<int> strata(patterns.size());
    for (auto& [edges, members] : by_edges) {
        std::ranges::sort(members);
        for (std::size_t rank = 0; rank < members.size(); ++rank) {
            strata[members[rank].second] = 3 * edges + third_of(rank, members.size());
        }
    }
    return strata;
}

std::vector<std::string> pattern_ids(std::size_t count) {
    const auto all = pattern::enumerate_patterns(
        pattern::paper_layout(),
        {.edges = pattern::default_edge_range(pattern::paper_layout()), .filters = {}});
    std::vector<std::string> ids;
    for (const std::size_t index : stratified_sample(strata_of(all), count)) {
        ids.push_back("calibration/" + pattern::pattern_id(pattern::paper_layout(), all[index]));
    }
    return ids;
}

}  // namespace

ProblemFamilies study_families(const std::vector<NamedSetting>& settings) {
    for (const NamedSetting& named : settings) {
        if (named.name.empty() || named.name.find_first_of("@/,: \t\n\"") != std::string::npos)
            throw base::InputError(
                "'" + base::printable(named.name) +
                "' cannot name a setting in ids of problems; a name has no '@', '/', ',', ':', "
                "quotes and blanks");
    }
    const auto calibration = [settings](const std::string& id, const std::string& name) {
        return calibration_problem(id, name, settings);
    };
    return {{"calibration", calibration},
            {"synthetic", synthetic_problem},
            optimization::study::analytic_family()};
}

std::vector<std::string> study_problem_ids_in(const std::string& setting, std::size_t patterns) {
    std::vector<std::string> ids = pattern_ids(patterns);
    for (std::string& id : ids) id += "@" + setting;
    return ids;
}

std::vector<std::string> study_problem_ids(std::size_t patterns) {
    std::vector<std::string> ids = pattern_ids(patterns);
    for (int n = 1; n <= kSyntheticProblems; ++n) ids.push_back("synthetic/" + std::to_string(n));
    for (std::string& id : optimization::study::analytic_problem_ids()) ids.push_back(std::move(id));
    return ids;
}

}  // namespace fretwork::reduction

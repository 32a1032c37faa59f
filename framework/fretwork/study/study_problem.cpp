// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/problems/analytic_problems.hpp>
#include <fretwork/optimization/random.hpp>
#include <fretwork/pattern/enumerate.hpp>
#include <fretwork/reduction/effective_properties.hpp>
#include <fretwork/reduction/linear_response.hpp>
#include <fretwork/reduction/ring/ring_problem.hpp>
#include <fretwork/reduction/stratified_sample.hpp>
#include <fretwork/study/study_problem.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace fretwork::study {
namespace {

constexpr int kSyntheticProblems = 12;

/// The paper's problem with what it refers to.
class OwnedProblem final {
  public:
    OwnedProblem(const std::vector<reduction::Response>& responses, const reduction::Setting& setting)
        : model_(setting),
          objective_(responses, setting),
          problem_(model_, reduction::paper6_parameters(), objective_, setting) {}
    OwnedProblem(const OwnedProblem&) = delete;
    OwnedProblem& operator=(const OwnedProblem&) = delete;
    [[nodiscard]] const reduction::RingProblem& problem() const { return problem_; }

  private:
    reduction::RingHexagon model_;
    reduction::Objective objective_;
    reduction::RingProblem problem_;
};

std::shared_ptr<const reduction::RingProblem> make_calibration(
    const std::vector<reduction::Response>& responses, const reduction::Setting& setting) {
    const auto owner = std::make_shared<const OwnedProblem>(responses, setting);
    return {owner, &owner->problem()};
}

const pattern::NodeLayout& paper_layout() {
    static const pattern::NodeLayout layout = pattern::find_node_layout("paper7");
    return layout;
}

/// The layout that stands before a pattern's id, or else the paper's.
pattern::NodeLayout layout_of(const std::string& pattern_id) {
    const auto colon = pattern_id.find(':');
    return colon == std::string::npos ? paper_layout()
                                      : pattern::find_node_layout(pattern_id.substr(0, colon));
}

StudyProblem calibration_problem(const std::string& id, const std::string& pattern_id) {
    const auto setting = reduction::paper_setting();
    const auto layout = layout_of(pattern_id);
    const auto pattern = pattern::parse_pattern_id(layout, pattern_id);
    if (!reduction::RingHexagon::fits(layout, setting))
        throw base::InputError("'" + id + "': problems are of layouts with one interface node a side, and '" +
                               layout.name() + "' has more");
    const auto responses = reduction::compute_responses(layout, pattern, setting);
    return {id, make_calibration(responses, setting), std::nullopt, {}};
}

StudyProblem synthetic_problem(const std::string& id, const std::string& number) {
    const int n = base::read_number<int>(number).value_or(0);
    if (n < 1 || number != std::to_string(n))  // one problem has one id
        throw base::InputError("'" + id + "' is no synthetic problem, such as synthetic/1");
    const auto setting = reduction::paper_setting();
    const auto any = make_calibration(
        linear_responses(reduction::UnitDisplacements(setting.scenarios.size(),
                                                      mechanics::NodeValues::Ones(setting.sides, 6)),
                         setting),
        setting);
    optimization::RandomStream random(static_cast<std::uint64_t>(n), 0);
    Eigen::VectorXd shares(any->bounds().dimension());
    for (double& share : shares) share = 0.1 + 0.8 * random.uniform();
    const Eigen::VectorXd optimum = any->bounds().at_shares(shares);
    const auto target = linear_responses(any->displacements(optimum), setting);
    return {id, make_calibration(target, setting), 0.0, optimum};
}

StudyProblem analytic_problem(const std::string& id, const std::string& name) {
    std::vector<std::string> names;
    for (auto& candidate : optimization::analytic_problems()) {
        names.push_back(candidate.problem->name());
        if (names.back() == name) {
            return {id, std::move(candidate.problem), candidate.best_value, candidate.best_point};
        }
    }
    throw base::InputError(base::unknown_name_message("analytic problem", name, names));
}

/// The third of the ranks 0..count-1 in which a rank lies.
int third_of(std::size_t rank, std::size_t count) {
    return static_cast<int>(3 * rank / count);
}

/// One label for each pattern: number of edges and, among its like, softer, middling or stiffer in bending.
std::vector<int> strata_of(const std::vector<pattern::Pattern>& patterns) {
    const auto setting = reduction::paper_setting();
    std::map<int, std::vector<std::pair<double, std::size_t>>> by_edges;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const auto plate = reduction::effective_properties(paper_layout(), patterns[i], setting);
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
        paper_layout(), {.edges = pattern::default_edge_range(paper_layout()), .filters = {}});
    std::vector<std::string> ids;
    for (const std::size_t index : reduction::stratified_sample(strata_of(all), count)) {
        ids.push_back("calibration/" + pattern::pattern_id(paper_layout(), all[index]));
    }
    return ids;
}

/// N of a family, or all of it, for "family", "family:N".
void choose_family(const std::vector<std::string>& ids, const std::string& word,
                   std::set<std::string>& chosen) {
    const auto parts = base::split(word, ':');
    std::vector<std::string> members;
    std::ranges::copy_if(ids, std::back_inserter(members),
                         [&](const std::string& id) { return family_of(id) == parts.front(); });
    std::size_t count = members.size();
    if (parts.size() == 2) count = base::read_number<std::size_t>(parts[1]).value_or(0);
    if (!members.empty() && count > members.size())
        throw base::InputError("'" + word + "': there are " + std::to_string(members.size()) +
                               " of that family");
    if (members.empty() || count == 0 || parts.size() > 2) {
        throw base::InputError("'" + word + "' is no problem that is known, no family and no family:N");
    }
    for (std::size_t k = 0; k < count; ++k)
        chosen.insert(members[(2 * k + 1) * members.size() / (2 * count)]);
}

}  // namespace

std::string family_of(const std::string& id) {
    return id.substr(0, id.find('/'));
}

StudyProblem make_study_problem(const std::string& id) {
    const std::string family = family_of(id);
    const std::string name = id.size() > family.size() ? id.substr(family.size() + 1) : "";
    if (family == "calibration") return calibration_problem(id, name);
    if (family == "synthetic") return synthetic_problem(id, name);
    if (family == "analytic") return analytic_problem(id, name);
    throw base::InputError(base::unknown_name_message(
        "family of problems", family, std::vector<std::string>{"calibration", "synthetic", "analytic"}));
}

std::vector<std::string> study_problem_ids(std::size_t patterns) {
    std::vector<std::string> ids = pattern_ids(patterns);
    for (int n = 1; n <= kSyntheticProblems; ++n) ids.push_back("synthetic/" + std::to_string(n));
    for (const auto& entry : optimization::analytic_problems()) {
        ids.push_back("analytic/" + entry.problem->name());
    }
    return ids;
}

std::vector<std::string> read_problem_ids(const std::filesystem::path& path) {
    const auto lines = base::split(base::read_text_file(path), '\n');
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const std::string place = "line " + std::to_string(i + 1);
        if (std::ranges::find(ids, lines[i]) != ids.end())
            throw base::InputError(path.string(), place, "problem " + lines[i] + " stands there already");
        try {
            (void)make_study_problem(lines[i]);
        } catch (const base::InputError& error) {
            throw base::InputError(path.string(), place, error.what());
        }
        ids.push_back(lines[i]);
    }
    if (ids.empty()) throw base::InputError(path.string() + ": names no problem");
    return ids;
}

std::vector<std::string> chosen_problems(const std::vector<std::string>& ids, const std::string& choice) {
    if (choice == "all") return ids;
    std::set<std::string> chosen;
    for (const std::string& word : base::split(choice, ',')) {
        if (std::ranges::find(ids, word) != ids.end()) {
            chosen.insert(word);
        } else {
            choose_family(ids, word, chosen);
        }
    }
    std::vector<std::string> matching;
    std::ranges::copy_if(ids, std::back_inserter(matching),
                         [&](const std::string& id) { return chosen.contains(id); });
    return matching;
}

}  // namespace fretwork::study

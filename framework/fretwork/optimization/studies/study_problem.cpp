// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/optimization/problems/analytic_problems.hpp>
#include <fretwork/optimization/studies/study_problem.hpp>

#include <algorithm>
#include <set>

namespace fretwork::optimization::study {
namespace {

StudyProblem analytic_problem(const std::string& id, const std::string& name) {
    std::vector<std::string> names;
    for (auto& candidate : optimization::analytic_problems()) {
        names.push_back(candidate.problem->name());
        if (names.back() == name) {
            return {id, std::move(candidate.problem), candidate.best_value, candidate.best_point, {}};
        }
    }
    throw base::InputError(base::unknown_name_message("analytic problem", name, names));
}

/// Choose all problems of a family ("family") or N of them ("family:N").
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
        throw base::InputError("'" + word + "' is not a known problem, family or family:N");
    }
    for (std::size_t k = 0; k < count; ++k)
        chosen.insert(members[(2 * k + 1) * members.size() / (2 * count)]);
}

}  // namespace

std::string family_of(const std::string& id) {
    return id.substr(0, id.find('/'));
}

ProblemFamily analytic_family() {
    return {"analytic", analytic_problem};
}

std::vector<std::string> analytic_problem_ids() {
    std::vector<std::string> ids;
    for (const auto& entry : optimization::analytic_problems())
        ids.push_back("analytic/" + entry.problem->name());
    return ids;
}

StudyProblem make_study_problem(const std::string& id, const ProblemFamilies& families) {
    const std::string name = family_of(id);
    std::vector<std::string> names;
    for (const ProblemFamily& family : families) {
        if (family.name == name)
            return family.make(id, id.size() > name.size() ? id.substr(name.size() + 1) : "");
        names.push_back(family.name);
    }
    throw base::InputError(base::unknown_name_message("family of problems", name, names));
}

std::vector<std::string> read_problem_ids(const std::filesystem::path& path,
                                          const ProblemFamilies& families) {
    const auto lines = base::split_lines(base::read_text_file(path));
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        const std::string place = "line " + std::to_string(i + 1);
        if (std::ranges::find(ids, lines[i]) != ids.end())
            throw base::InputError(path.string(), place, "problem " + lines[i] + " stands there already");
        base::located(path.string(), place, [&] { (void)make_study_problem(lines[i], families); });
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

}  // namespace fretwork::optimization::study

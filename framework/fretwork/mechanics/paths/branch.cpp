// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/paths/branch.hpp>

#include <utility>

namespace fretwork::mechanics {
namespace {

constexpr std::pair<Branch, std::string_view> kBranches[] = {
    {Branch::Primary, "primary"}, {Branch::Stable, "stable"}, {Branch::Snapping, "snapping"}};

}  // namespace

std::string_view branch_name(Branch branch) {
    for (const auto& [known, name] : kBranches) {
        if (known == branch) return name;
    }
    return "";
}

std::vector<std::string> branch_names() {
    std::vector<std::string> names;
    for (const auto& [branch, name] : kBranches) names.emplace_back(name);
    return names;
}

Branch find_branch(std::string_view name) {
    for (const auto& [branch, its_name] : kBranches) {
        if (its_name == name) return branch;
    }
    throw base::InputError(base::unknown_name_message("branch", std::string(name), branch_names()));
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/named.hpp>
#include <fretwork/mechanics/paths/branch.hpp>

#include <utility>

namespace fretwork::mechanics {
namespace {

using NamedBranch = std::pair<Branch, std::string_view>;
constexpr NamedBranch kBranches[] = {
    {Branch::Primary, "primary"}, {Branch::Stable, "stable"}, {Branch::Snapping, "snapping"}};

}  // namespace

std::string_view branch_name(Branch branch) {
    for (const auto& [known, name] : kBranches) {
        if (known == branch) return name;
    }
    return "";
}

std::vector<std::string> branch_names() {
    return base::names_of(kBranches, &NamedBranch::second);
}

Branch find_branch(std::string_view name) {
    return base::find_named(name, kBranches, &NamedBranch::second, "branch").first;
}

}  // namespace fretwork::mechanics

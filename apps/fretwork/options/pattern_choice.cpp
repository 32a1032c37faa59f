// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/pattern_choice.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>

#include <algorithm>
#include <string_view>

namespace fretwork::app {
namespace {

std::size_t parse_count(std::string_view text, const char* option, const char* what) {
    if (const auto number = base::read_number<std::size_t>(text); number && *number > 0) return *number;
    throw base::InputError(option, "", "'" + std::string(text) + "' is not a " + what);
}

}  // namespace

std::vector<pattern::NamedPattern> wanted_patterns(const library::Library& library,
                                                   const std::string& choice) {
    if (choice == "all") return library.patterns();
    if (choice == "computed") return library.patterns_with_responses();
    if (choice.starts_with("sample:")) {
        return library.sample(
            parse_count(std::string_view(choice).substr(7), "--patterns", "number of patterns"));
    }
    std::vector<pattern::NamedPattern> chosen;
    for (const std::string& id : base::split(choice, ',')) chosen.push_back(library.find_pattern(id));
    std::ranges::sort(chosen, library::comes_before);
    const auto repeated = std::ranges::unique(chosen, {}, &pattern::NamedPattern::id);
    chosen.erase(repeated.begin(), repeated.end());
    return chosen;
}

std::vector<pattern::NamedPattern> in_shard(std::vector<pattern::NamedPattern> patterns,
                                            const std::string& shard) {
    if (shard.empty()) return patterns;
    const auto parts = base::split(shard, '/');
    if (parts.size() != 2)
        throw base::InputError("--shard", "", "'" + shard + "' is not a shard, such as 2/4");
    const std::size_t number = parse_count(parts[0], "--shard", "number of a shard");
    const std::size_t count = parse_count(parts[1], "--shard", "number of shards");
    if (number > count) throw base::InputError("--shard", "", "there is no shard " + shard);
    std::vector<pattern::NamedPattern> kept;
    for (std::size_t i = number - 1; i < patterns.size(); i += count) kept.push_back(std::move(patterns[i]));
    return kept;
}

}  // namespace fretwork::app

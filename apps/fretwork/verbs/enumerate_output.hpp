// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/census.hpp>
#include <fretwork/pattern/sameness.hpp>
#include <fretwork/pattern/sample.hpp>

#include <optional>
#include <span>

namespace fretwork::app {

// The output of the verb enumerate.

enum class Audience { People, Programs };

void print_count(const pattern::NodeLayout& layout, std::uint64_t count, Audience audience);
void print_estimate(const pattern::NodeLayout& layout, const pattern::CountEstimate& estimate,
                    Audience audience);
void print_ids(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
               Audience audience);
/// The census, and how many patterns there are up to mirror and isomorphism where that was asked for.
void print_census(const pattern::NodeLayout& layout, const pattern::Census& census,
                  const std::optional<pattern::SamenessReport>& sameness, Audience audience);

}  // namespace fretwork::app

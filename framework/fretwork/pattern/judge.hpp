// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/pattern/filter_catalogue.hpp>
#include <fretwork/pattern/rule.hpp>

#include <span>

namespace fretwork::pattern {

/// The verdict of one filter on a pattern.
Verdict judge(const NodeLayout& layout, const Filter& filter, const Pattern& pattern);
/// The verdict of the first filter that rejects a pattern.
Verdict judge(const NodeLayout& layout, std::span<const Filter> filters, const Pattern& pattern);

}  // namespace fretwork::pattern

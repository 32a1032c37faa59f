// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/pattern/filters/filters.hpp>
#include <fretwork/pattern/mirror.hpp>

namespace fretwork::pattern::filters {

Rule make_asymmetric(const NodeLayout& layout, double, const FabricationScale&) {
    const auto is_kept = [mirror = Mirror(layout)](const Pattern& pattern) {
        return mirror.is_symmetric(pattern);
    };
    return PredicateRule{is_kept, "the pattern is not its own mirror image"};
}

}  // namespace fretwork::pattern::filters

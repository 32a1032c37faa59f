// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/library/detail/pattern_order.hpp>
#include <fretwork/library/library.hpp>

#include <algorithm>

namespace fretwork::library {
namespace detail {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Remove the digits at the start of a text and return them. Numbers in ids have no leading zeros.
std::string_view take_number(std::string_view& text) {
    const auto end = std::ranges::find_if_not(text, is_digit);
    const std::string_view digits = text.substr(0, end - text.begin());
    text.remove_prefix(digits.size());
    return digits;
}

}  // namespace

bool id_comes_before(std::string_view left, std::string_view right) {
    while (!left.empty() && !right.empty()) {
        if (is_digit(left.front()) && is_digit(right.front())) {
            const std::string_view a = take_number(left);
            const std::string_view b = take_number(right);
            if (a.size() != b.size()) return a.size() < b.size();
            if (a != b) return a < b;
        } else {
            if (left.front() != right.front()) return left.front() < right.front();
            left.remove_prefix(1);
            right.remove_prefix(1);
        }
    }
    return left.empty() && !right.empty();
}

}  // namespace detail

bool comes_before(const pattern::NamedPattern& left, const pattern::NamedPattern& right) {
    const int left_count = left.pattern.edge_count();
    const int right_count = right.pattern.edge_count();
    if (left_count != right_count) return left_count < right_count;
    // The lowest edge that is in only one of the two sets decides: the set with this edge comes first.
    const pattern::Pattern::Bits difference = left.pattern.bits() ^ right.pattern.bits();
    const std::size_t first = difference._Find_first();
    return first < difference.size() && left.pattern.bits().test(first);
}

}  // namespace fretwork::library

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace fretwork::base {

/// An integer that counts one kind of thing: an index of a node cannot be passed where one of a beam is
/// wanted.
///
/// It converts to a plain integer silently (to index a vector), and from one only where that is spelled out.
template <class Tag>
struct Index {
    std::int32_t value = -1;

    constexpr Index() = default;
    constexpr explicit Index(std::integral auto number) : value(static_cast<std::int32_t>(number)) {}
    constexpr operator std::int32_t() const { return value; }  // NOLINT(google-explicit-constructor)
    [[nodiscard]] constexpr bool is_valid() const { return value >= 0; }

    friend constexpr auto operator<=>(Index left, Index right) = default;
    friend constexpr bool operator==(Index left, Index right) = default;
};

/// The place of a plain, valid index in a container of the standard library.
constexpr std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace fretwork::base

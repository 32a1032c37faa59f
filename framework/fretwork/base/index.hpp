// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace fretwork::base {

/// An integer that numbers things of one kind. The index of a node cannot be passed as the index of a beam:
/// this does not compile.
///
/// An Index converts to a plain integer implicitly (to index a vector). A plain integer converts to an Index
/// only explicitly.
template <class Tag>
struct Index {
    std::int32_t value = -1;  ///< -1: none

    constexpr Index() = default;
    /// Make an index from a number.
    constexpr explicit Index(std::integral auto number) : value(static_cast<std::int32_t>(number)) {}
    /// The number, to index an array.
    constexpr operator std::int32_t() const { return value; }  // NOLINT(google-explicit-constructor)
    /// True if the number is not below 0.
    [[nodiscard]] constexpr bool is_valid() const { return value >= 0; }

    friend constexpr auto operator<=>(Index left, Index right) = default;
    friend constexpr bool operator==(Index left, Index right) = default;
};

/// A valid `int` index as the std::size_t that containers of the standard library take.
constexpr std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace fretwork::base

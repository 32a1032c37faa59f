// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/index.hpp>

#include <ranges>
#include <vector>

namespace fretwork::base {

/// A vector that takes one type of Index: `tiles[tile]` is an element, and `tiles[interface_node]` does not
/// compile. A plain integer, such as std::size_t in a loop, compiles as well.
/// @tparam Role  the type of index, an Index<..>
template <class Role, class T>
class IndexVector : public std::vector<T> {
  public:
    using std::vector<T>::vector;
    using std::vector<T>::operator=;
    using std::vector<T>::operator[];
    IndexVector() = default;
    /// Take the elements of a vector as they are.
    IndexVector(std::vector<T> elements)  // NOLINT(google-explicit-constructor): the same elements
        : std::vector<T>(std::move(elements)) {}

    /// The element at an index of type Role.
    [[nodiscard]] T& operator[](Role index) { return (*this)[static_cast<std::size_t>(index.value)]; }
    /// The element at an index of type Role.
    [[nodiscard]] const T& operator[](Role index) const {
        return (*this)[static_cast<std::size_t>(index.value)];
    }
    template <class Tag>
    void operator[](Index<Tag> other_role) = delete;
    template <class Tag>
    void operator[](Index<Tag> other_role) const = delete;

    /// True if the vector has an element of this index.
    [[nodiscard]] bool has(Role index) const {
        return index.is_valid() && static_cast<std::size_t>(index.value) < this->size();
    }
    /// The indices of all elements, ascending.
    [[nodiscard]] auto indices() const {
        return std::views::iota(std::int32_t{0}, static_cast<std::int32_t>(this->size())) |
               std::views::transform([](std::int32_t number) { return Role(number); });
    }
};

}  // namespace fretwork::base

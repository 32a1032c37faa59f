// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fretwork::base {

/// A reference to an object that its owner keeps alive. Inputs and problems have members of this type.
///
/// A Borrowed of a temporary, such as the result of `paper_setting()`, does not compile. A Borrowed is copied
/// and passed like a reference.
template <class T>
class Borrowed {
  public:
    /// Refer to an object, which has to outlive the Borrowed.
    constexpr Borrowed(const T& object) : object_(&object) {}  // NOLINT(google-explicit-constructor)
    Borrowed(const T&&) = delete;

    /// The object.
    constexpr operator const T&() const { return *object_; }  // NOLINT(google-explicit-constructor)
    /// The object.
    constexpr const T& operator*() const { return *object_; }
    /// The object.
    constexpr const T* operator->() const { return object_; }

  private:
    const T* object_;
};

}  // namespace fretwork::base

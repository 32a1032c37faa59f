// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace fretwork::base {

/// A reference to an object that somebody else keeps alive, for members of inputs and of problems.
///
/// It refuses temporaries when it is compiled: an input with a borrowed setting cannot be made of
/// `paper_setting()` and outlive it. It is copied and passed like the reference it is.
template <class T>
class Borrowed {
  public:
    constexpr Borrowed(const T& object) : object_(&object) {}  // NOLINT(google-explicit-constructor)
    Borrowed(const T&&) = delete;

    constexpr operator const T&() const { return *object_; }  // NOLINT(google-explicit-constructor)
    constexpr const T& operator*() const { return *object_; }
    constexpr const T* operator->() const { return object_; }

  private:
    const T* object_;
};

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>

#include <atomic>
#include <optional>
#include <string>
#include <utility>

namespace fretwork::python {

/// An object that one thread may use at a time, and that can be closed. Calls run without the GIL, so two
/// threads could race; the second thread gets an error instead.
template <class T>
class SharedObject {
  public:
    SharedObject(T object, std::string name) : object_(std::move(object)), name_(std::move(name)) {}

    /// Access to the object during one call. The constructor throws Error if another call uses the object.
    /// Access throws Error after close().
    class Use {
      public:
        explicit Use(SharedObject& shared) : shared_(shared) {
            if (shared.is_in_use_.test_and_set())
                throw base::Error("the " + shared.name_ +
                                  " is in use by another call; give each thread its own");
        }
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;
        ~Use() { shared_.is_in_use_.clear(); }
        T& operator*() const { return *get(); }
        T* operator->() const { return get(); }
        void close() const { shared_.object_.reset(); }

      private:
        /// Throws Error if the object is closed.
        [[nodiscard]] T* get() const {
            if (!shared_.object_) throw base::Error("the " + shared_.name_ + " is closed");
            return &*shared_.object_;
        }
        SharedObject& shared_;
    };
    Use use() { return Use(*this); }

  private:
    std::atomic_flag is_in_use_;
    std::optional<T> object_;
    std::string name_;
};

}  // namespace fretwork::python

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shared_object.hpp"

#include <fretwork/library/library.hpp>

#include <memory>

namespace fretwork::python {

using LibraryObject = SharedObject<library::Library>;
using LibraryPointer = std::shared_ptr<LibraryObject>;

/// Returns work(pointer), where the pointer is null if there is no library. The library is in use meanwhile.
/// Throws Error if another call uses the library, or if the library is closed.
template <class Work>
auto with_library(const LibraryPointer& library, const Work& work) {
    if (!library) return work(static_cast<const library::Library*>(nullptr));
    const auto use = library->use();
    return work(static_cast<const library::Library*>(&*use));
}

}  // namespace fretwork::python

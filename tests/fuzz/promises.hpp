// SPDX-License-Identifier: GPL-3.0-or-later
// Promises that readers keep besides not to crash.
#pragma once

#include <fretwork/base/error.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace fretwork::fuzz {

/// End the program if a promise is broken: a fuzzer keeps the input then.
inline void promise(bool is_kept, const char* which, std::string_view bytes) {
    if (is_kept) return;
    std::fprintf(stderr, "broken promise: %s\n%.*s\n", which, static_cast<int>(bytes.size()), bytes.data());
    std::abort();
}

/// A value that was read is written as a text that is read again, as a value that is written as the same
/// text.
template <class Read, class Write>
void promise_round_trip(std::string_view bytes, const Read& read, const Write& write) {
    const std::string first = write(read(bytes));
    std::string second;
    try {
        second = write(read(first));
    } catch (const base::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        promise(false, "what is written can be read", first);
    }
    promise(first == second, "what is written is read as it was", first);
}

}  // namespace fretwork::fuzz

// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers in binary files.
#pragma once

#include <cstdint>
#include <string>

namespace fretwork::exports::detail {

/// Append a number of four bytes in little endian order, on any machine.
inline void append_bits(std::string& text, std::uint32_t bits) {
    for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>((bits >> shift) & 0xFFU);
}

}  // namespace fretwork::exports::detail

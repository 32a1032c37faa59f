// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fretwork::base {

/// The secure hash SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Sha256 {
  public:
    void update(std::string_view bytes);
    /// The hash of all bytes so far, as 64 hexadecimal digits. More bytes may follow.
    [[nodiscard]] std::string hexadecimal() const;

  private:
    void process_block(const unsigned char* block);

    std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                           0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    std::array<unsigned char, 64> pending_{};
    std::uint64_t length_ = 0;  ///< bytes so far; the last length_ % 64 of them are pending
};

/// The SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace fretwork::base

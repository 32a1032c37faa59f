// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace fretwork::base {

/// The hash SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Sha256 {
  public:
    /// Begin with nothing hashed.
    Sha256();
    Sha256(Sha256&&) noexcept;
    Sha256& operator=(Sha256&&) noexcept;
    ~Sha256();

    /// Hash further bytes.
    void update(std::string_view bytes);
    /// The hash of all bytes so far, as 64 hexadecimal digits. More bytes may follow.
    [[nodiscard]] std::string hexadecimal() const;

  private:
    struct State;  ///< the state of the hashing library
    std::unique_ptr<State> state_;
};

/// The SHA-256 of a text as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace fretwork::base

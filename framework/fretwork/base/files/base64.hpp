// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::base {

/// Bytes from their Base64 (RFC 4648; line breaks and spaces are passed over). Throws InputError that names
/// `source` if the text is no Base64.
std::string decode_base64(std::string_view text, const std::string& source);
/// Without line breaks.
std::string encode_base64(std::string_view bytes);

}  // namespace fretwork::base

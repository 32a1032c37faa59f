// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace fretwork::base {

/// Decode Base64 (RFC 4648). Line breaks and spaces in the text are skipped. Throws InputError that names
/// `source` if the text is not Base64.
std::string decode_base64(std::string_view text, const std::string& source);
/// Encode bytes as Base64 without line breaks.
std::string encode_base64(std::string_view bytes);

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/base64.hpp>

#include <nettle/base64.h>

namespace fretwork::base {

std::string decode_base64(std::string_view text, const std::string& source) {
    base64_decode_ctx context;
    base64_decode_init(&context);
    std::string bytes(BASE64_DECODE_LENGTH(text.size()), '\0');
    std::size_t size = bytes.size();
    const bool is_decoded = base64_decode_update(
        &context, &size, reinterpret_cast<std::uint8_t*>(bytes.data()), text.size(), text.data());
    if (!is_decoded || base64_decode_final(&context) == 0) throw InputError(source, "", "is no Base64 text");
    bytes.resize(size);
    return bytes;
}

std::string encode_base64(std::string_view bytes) {
    std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    return text;
}

}  // namespace fretwork::base

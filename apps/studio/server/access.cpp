// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <studio/server/access.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <sys/random.h>

namespace fretwork::studio {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

bool is_port(std::string_view text) {
    return !text.empty() && text.size() <= 5 &&
           std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// The text before a colon and a port, or the whole text without one.
std::string_view without_port(std::string_view host) {
    const std::size_t colon = host.rfind(':');
    if (colon == std::string_view::npos || host.ends_with(']')) return host;
    return is_port(host.substr(colon + 1)) ? host.substr(0, colon) : host;
}

std::optional<char> read_escape(std::string_view text) {
    if (text.size() < 3) return std::nullopt;
    unsigned value = 0;
    const char* end = text.data() + 3;
    if (std::from_chars(text.data() + 1, end, value, 16).ptr != end) return std::nullopt;
    return static_cast<char>(value);
}

/// A text with its %41 and + resolved.
std::optional<std::string> unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%') {
            const auto character = read_escape(text.substr(i));
            if (!character) return std::nullopt;
            result += *character;
            i += 2;
        } else {
            result += text[i] == '+' ? ' ' : text[i];
        }
    }
    return result;
}

}  // namespace

std::string make_token() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw base::IoError("the system gives no random numbers");
    std::string token;
    for (const unsigned char byte : bytes) {
        token += kDigits[byte >> 4U];
        token += kDigits[byte & 0xfU];
    }
    return token;
}

bool is_own_host(std::string_view host, std::string_view address) {
    const std::string_view name = without_port(host);
    if (name == "127.0.0.1" || name == "localhost" || name == "[::1]") return true;
    const bool is_bracketed = name.starts_with('[') && name.ends_with(']');
    return !address.empty() && (is_bracketed ? name.substr(1, name.size() - 2) : name) == address;
}

bool is_own_origin(std::string_view origin, std::string_view address) {
    constexpr std::string_view kScheme = "http://";
    return origin.starts_with(kScheme) && is_own_host(origin.substr(kScheme.size()), address);
}

std::string Target::value(std::string_view name) const {
    const auto found = values.find(name);
    return found == values.end() ? "" : found->second;
}

std::optional<Target> parse_target(std::string_view text) {
    if (!text.starts_with('/')) return std::nullopt;
    const std::size_t mark = text.find('?');
    const auto path = unescaped(text.substr(0, mark));
    if (!path) return std::nullopt;
    Target target{*path, {}};
    std::string_view rest = mark == std::string_view::npos ? std::string_view() : text.substr(mark + 1);
    while (!rest.empty()) {
        const std::string_view pair = rest.substr(0, rest.find('&'));
        rest.remove_prefix(std::min(rest.size(), pair.size() + 1));
        const std::size_t equals = pair.find('=');
        if (equals == std::string_view::npos) return std::nullopt;
        const auto name = unescaped(pair.substr(0, equals));
        const auto value = unescaped(pair.substr(equals + 1));
        if (!name || !value || !target.values.emplace(*name, *value).second) return std::nullopt;
    }
    return target;
}

std::string escaped(std::string_view text) {
    std::string result;
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        const bool is_plain =
            byte < 0x80 &&
            (std::isalnum(byte) != 0 || std::string_view("-._~/").find(character) != std::string_view::npos);
        if (is_plain) {
            result += character;
        } else {
            result += '%';
            result += kDigits[byte >> 4U];
            result += kDigits[byte & 0xfU];
        }
    }
    return result;
}

bool is_token(std::string_view given, std::string_view token) {
    unsigned difference = given.size() == token.size() ? 0 : 1;
    for (std::size_t i = 0; i < token.size(); ++i) {
        const char other = i < given.size() ? given[i] : '\0';
        difference |= static_cast<unsigned char>(token[i] ^ other);
    }
    return difference == 0;
}

}  // namespace fretwork::studio

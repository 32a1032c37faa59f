// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace fretwork::studio {

/// A secret of 128 random bits, in hexadecimal. All URLs of the studio contain it. Throws IoError if the
/// system gives no random numbers.
std::string make_token();

/// Whether a request's Host or Origin is this machine: 127.0.0.1, localhost or [::1] with any port, so that a
/// forwarded port works; or `address`, the IP address at which the server listens. A page of any other origin
/// shall reach nothing, even if its name resolves to this machine.
bool is_own_host(std::string_view host, std::string_view address);
bool is_own_origin(std::string_view origin, std::string_view address);

/// The path and the named values of a request's target, "/export?to=a.svg&token=..".
struct Target {
    std::string path;
    std::map<std::string, std::string, std::less<>> values;
    /// "" if the name is missing.
    [[nodiscard]] std::string value(std::string_view name) const;
};
/// Nothing if it is malformed.
std::optional<Target> parse_target(std::string_view text);

/// A text as a value in a URL: each byte like %41, except ASCII letters, digits and "-._~/".
std::string escaped(std::string_view text);

/// Compares in a time that does not depend on how much of the token is right.
bool is_token(std::string_view given, std::string_view token);

}  // namespace fretwork::studio

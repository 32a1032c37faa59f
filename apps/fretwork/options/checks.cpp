// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/checks.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>

#include <cmath>

namespace fretwork::app {
namespace {

/// @param what  the end of the error "'TEXT' is not ..": "a seed: expected .."
CLI::Validator validator(bool (*is_valid)(const std::string&), const std::string& what, const char* type) {
    const auto check = [is_valid, what](const std::string& text) {
        return is_valid(text) ? std::string() : "'" + text + "' is not " + what;
    };
    return {check, type, type};
}

bool is_seed(const std::string& text) {
    const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return is_number && text.size() <= 18;
}

bool is_not_negative(const std::string& text) {
    const auto number = base::read_number<double>(text);
    return number && *number >= 0.0 && std::isfinite(*number);
}

bool is_above_zero(const std::string& text) {
    return is_not_negative(text) && *base::read_number<double>(text) > 0.0;
}

bool is_length(const std::string& text) {
    try {
        return base::parse_length(text) >= 0.0;
    } catch (const base::InputError&) {
        return false;
    }
}

}  // namespace

CLI::Validator seed_check() {
    return validator(is_seed, "a seed: expected 0 to 999999999999999999", "SEED");
}

CLI::Validator thread_check() {
    return CLI::Range(0, 256);
}

CLI::Validator not_negative_check() {
    return validator(is_not_negative, "a number of zero or more", "NUMBER");
}

CLI::Validator above_zero_check() {
    return validator(is_above_zero, "a number above zero; without the option there is no limit", "NUMBER");
}

CLI::Validator length_check() {
    return validator(is_length, "a length, such as 0.5mm", "LENGTH");
}

void refuse_given(const CLI::App& verb, std::initializer_list<const char*> options, const std::string& why) {
    for (const char* option : options) {
        if (verb.count(option) > 0) throw base::InputError(option, "", why);
    }
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/sandbox.hpp"

#include <fretwork/pattern/node_layout.hpp>

#include <algorithm>
#include <optional>
#include <string>

namespace fretwork::fuzz {
namespace {

namespace fs = std::filesystem;
using base::Json;

/// A member of a message, if it has it and it is a text.
std::optional<std::string> text_in(const Json& message, const char* name) {
    if (!message.is_object() || !message.contains(name) || !message[name].is_string()) return std::nullopt;
    return message[name].get<std::string>();
}

bool is_outside(const std::string& path, const fs::path& folder) {
    return fs::path(path).lexically_normal().parent_path() != folder;
}

bool is_shipped_layout(const std::string& name) {
    return std::ranges::count(pattern::layout_names(), name) > 0;
}

}  // namespace

bool leaves(const Json& message, const fs::path& folder) {
    if (const auto path = text_in(message, "path"); path && is_outside(*path, folder)) return true;
    for (const char* member : {"from", "layout"}) {
        const auto name = text_in(message, member);
        if (name && !is_shipped_layout(*name) && is_outside(*name, folder)) return true;
    }
    return false;
}

}  // namespace fretwork::fuzz

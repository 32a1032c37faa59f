// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.hpp"

#include <fretwork/base/error.hpp>

#include <filesystem>
#include <set>

namespace fretwork::app {
namespace {

namespace fs = std::filesystem;

/// One name for a file, whatever links and dots lead to it; devices are nobody's.
std::string name_of(const std::string& path) {
    std::error_code ignored;
    if (path.empty() || (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))) return "";
    const fs::path name = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    return name.empty() ? path : name.string();
}

}  // namespace

void check_outputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
    std::set<std::string> read;
    for (const std::string& input : inputs) read.insert(name_of(input));
    std::set<std::string> written;
    for (const std::string& output : outputs) {
        const std::string name = name_of(output);
        if (name.empty()) continue;
        if (read.contains(name))
            throw base::InputError(output, "", "is read by this command, and would be overwritten by it");
        if (!written.insert(name).second)
            throw base::InputError(output, "", "is named for two outputs of this command");
    }
}

}  // namespace fretwork::app

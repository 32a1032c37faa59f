// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/json_reader.hpp>
#include <studio/files/saving.hpp>

#include <utility>

namespace fretwork::studio {

void require_project_file(const std::filesystem::path& path) {
    if (path.extension() != ".json")
        throw base::InputError(path.string(), "", "is not a name for a project, which ends with .json");
    if (!std::filesystem::exists(path)) return;
    const auto json = base::JsonReader::from_file(path);
    json.expect_format("project", 1000);
}

base::FileLock lock_for_writing(const std::filesystem::path& path) {
    auto lock = base::FileLock::try_lock(std::filesystem::exists(path) ? path : path.parent_path());
    if (!lock)
        throw base::InputError(path.string(), "",
                               "is being written by another program: try again in a moment");
    return std::move(*lock);
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/json_reader.hpp>
#include <studio/files/saving.hpp>

#include <utility>

namespace fretwork::studio {

void require_file_of_kind(const std::filesystem::path& path, const std::string& kind) {
    if (base::ending_of(path) != ".json")
        throw base::InputError(path.string(), "", "is not a name for a " + kind + ", which ends with .json");
    if (!std::filesystem::exists(path)) return;
    const auto format = base::JsonReader::from_file(path).find("format");
    if (!format || !format->is_string() || !format->string().starts_with("fretwork/" + kind + "/"))
        throw base::InputError(path.string(), "", "is no " + kind + ", and is not replaced");
}

std::string Conflict::text() const {
    return path.filename().string() + (reason == Reason::Changed
                                           ? " was changed by another program since it was read here"
                                           : " is there already, and is another " + kind);
}

base::Json Conflict::json() const {
    return {{"conflict",
             {{"path", path.string()},
              {"hash", hash},
              {"reason", reason == Reason::Changed ? "changed" : "exists"}}}};
}

base::FileLock lock_for_writing(const std::filesystem::path& path) {
    auto lock = base::FileLock::try_lock(std::filesystem::exists(path) ? path : path.parent_path());
    if (!lock)
        throw base::InputError(path.string(), "",
                               "is being written by another program: try again in a moment");
    return std::move(*lock);
}

}  // namespace fretwork::studio

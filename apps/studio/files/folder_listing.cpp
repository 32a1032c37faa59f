// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <studio/files/folder_listing.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace fretwork::studio {
namespace {

namespace fs = std::filesystem;
using base::Json;

constexpr std::size_t kMostListed = 2000;

struct ListedEntry {
    std::string name;
    bool is_folder = false;
    std::int64_t seconds = 0;  ///< time of the last change, s since 1970
};

std::int64_t time_of(const fs::directory_entry& entry) {
    std::error_code error;
    const auto written = entry.last_write_time(error);
    if (error) return 0;
    const auto since = std::chrono::file_clock::to_sys(written).time_since_epoch();
    return std::chrono::duration_cast<std::chrono::seconds>(since).count();
}

/// Hidden entries are left out, and names that a message cannot hold.
bool is_shown(const std::string& name) {
    return !name.empty() && name.front() != '.' && base::printable(name) == name;
}

fs::directory_iterator opened(const fs::path& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw base::InputError(folder.string(), "", "is not a folder on the studio's computer");
    fs::directory_iterator entries(folder, error);
    if (error) throw base::InputError(folder.string(), "", "cannot be read: " + error.message());
    return entries;
}

std::vector<ListedEntry> entries_of(const fs::path& folder, const std::vector<std::string>& endings,
                                    const base::Control& control) {
    std::vector<ListedEntry> entries;
    std::error_code error;
    for (auto at = opened(folder); at != fs::directory_iterator(); at.increment(error)) {
        control.check();
        const std::string name = at->path().filename().string();
        if (!is_shown(name)) continue;
        std::error_code unknown;
        const bool is_folder = at->is_directory(unknown);
        const bool fits =
            endings.empty() || std::ranges::find(endings, base::ending_of(at->path())) != endings.end();
        if (is_folder || (fits && at->is_regular_file(unknown)))
            entries.push_back({name, is_folder, time_of(*at)});
    }
    // An increment that fails goes to the end.
    if (error) throw base::InputError(folder.string(), "", "cannot be read: " + error.message());
    std::ranges::sort(entries, {}, &ListedEntry::name);
    return entries;
}

Json path_or_null(const fs::path& path) {
    const std::string text = path.string();
    return text.empty() || base::printable(text) != text ? Json() : Json(text);
}

}  // namespace

Json folder_listing(const fs::path& folder, const std::vector<std::string>& endings,
                    const base::Control& control) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    const fs::path path = whole.has_filename() ? whole : whole.parent_path();
    Json folders = Json::array();
    Json files = Json::array();
    std::size_t left_out = 0;
    for (const ListedEntry& entry : entries_of(path, endings, control)) {
        if (folders.size() + files.size() == kMostListed) {
            ++left_out;
            continue;
        }
        const std::string place = (path / entry.name).string();
        (entry.is_folder ? folders : files)
            .push_back({{"name", entry.name}, {"path", place}, {"time", entry.seconds}});
    }
    const char* home = std::getenv("HOME");
    return {{"path", path.string()},
            {"parent", path.has_relative_path() ? path_or_null(path.parent_path()) : Json()},
            {"home", home == nullptr ? Json() : path_or_null(home)},
            {"folders", folders},
            {"files", files},
            {"left_out", left_out}};
}

}  // namespace fretwork::studio

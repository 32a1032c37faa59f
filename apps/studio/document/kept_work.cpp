// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <studio/document/kept_work.hpp>
#include <studio/server/words.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

namespace fretwork::studio {

namespace fs = std::filesystem;
using base::Json;

namespace {

/// Whether a file was written after an autosave of it: then people want to see the file first.
bool is_newer(const fs::path& file, const Recoverable& autosave) {
    std::error_code unknown;
    return std::chrono::file_clock::to_sys(fs::last_write_time(file, unknown)) > autosave.time;
}

}  // namespace

KeptWork::KeptWork(fs::path folder, std::function<void(const std::string&)> warn,
                   std::function<void(const std::string&)> failed)
    : folder_(std::move(folder)), warn_(std::move(warn)), autosave_(std::move(failed)) {}

std::optional<AutosavePlace> KeptWork::new_place(const std::optional<fs::path>& document) {
    trouble_.clear();
    try {
        return AutosavePlace(folder_, document);
    } catch (...) {
        trouble_ = base::handled_failure().text;
    }
    trouble_ = one_line("changes that are not saved are lost when the studio ends: " + trouble_);
    warn_(trouble_);
    return std::nullopt;
}

void KeptWork::take_place(std::optional<AutosavePlace> place, const std::optional<fs::path>& document) {
    place_ = place ? std::move(place) : new_place(document);
}

void KeptWork::keep(const Document& document) {
    if (document.is_saved()) return forget();
    if (place_) autosave_.keep(document.now(), {document.status().name, document.path()}, place_->file());
}

void KeptWork::forget() {
    if (place_) autosave_.forget(place_->file());
}

Opened KeptWork::with_changes(Document saved, const fs::path& file) const {
    const auto all = find_recoverable(folder_);
    const auto found =
        std::ranges::find_if(all, [&](const Recoverable& one) { return one.label.document == file; });
    if (found == all.end() || is_newer(file, *found)) return {std::move(saved)};
    auto place = AutosavePlace::take_over(found->file);
    if (!place) return {std::move(saved)};
    try {
        State changed = read_autosave(found->file);
        return {Document::recovered(std::move(saved), std::move(changed)), std::move(place)};
    } catch (const base::Error& error) {  // the file can be opened all the same
        warn_(error.what());
        return {std::move(saved)};
    }
}

Json KeptWork::recoverable_json() const {
    Json list = Json::array();
    for (const Recoverable& one : find_recoverable(folder_)) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(one.time.time_since_epoch());
        list.push_back({{"key", one.key},
                        {"name", one.label.name},
                        {"path", base::or_null(one.label.document)},
                        {"time", seconds.count()},
                        {"tiles", one.tiles}});
    }
    return list;
}

Recoverable KeptWork::find(const base::JsonReader& key) const {
    for (Recoverable& one : find_recoverable(folder_)) {
        if (one.key == key.string()) return std::move(one);
    }
    throw base::InputError("this is not there any more, or another studio shows it");
}

void KeptWork::forget(const Recoverable& found) {
    if (const auto place = AutosavePlace::take_over(found.file)) autosave_.forget(found.file);
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
// Documents that were not saved when a studio ended, or when another document took their place.
#include <fretwork/base/error.hpp>
#include <fretwork/simulation/project/project_library.hpp>
#include <studio/document/document_json.hpp>
#include <studio/server/words.hpp>
#include <studio/studio_impl.hpp>

#include <algorithm>

namespace fretwork::studio {

namespace fs = std::filesystem;
using base::Json;

namespace {

/// Whether a file was written after an autosave of it: then the autosave is not what people want to see
/// first.
bool is_newer(const fs::path& file, const Recoverable& autosave) {
    std::error_code unknown;
    return std::chrono::file_clock::to_sys(fs::last_write_time(file, unknown)) > autosave.time;
}

}  // namespace

std::optional<AutosavePlace> Studio::Impl::place_for(const std::optional<fs::path>& document) {
    no_autosave_.clear();
    try {
        return AutosavePlace(options_.state_folder, document);
    } catch (const base::Error& error) {
        no_autosave_ = error.what();
    } catch (const fs::filesystem_error& error) {
        no_autosave_ = in_words(error);
    }
    no_autosave_ = one_line("changes that are not saved are lost when the studio ends: " + no_autosave_);
    broadcast(Json{{"event", "warning"}, {"text", no_autosave_}});
    return std::nullopt;
}

void Studio::Impl::forget_kept() {
    if (autosave_place_) autosave_.forget(autosave_place_->file());
}

/// The hash is taken first: a change between the two is taken for one that this document does not know.
Document Studio::Impl::document_in(const fs::path& file) const {
    ProjectFile known{file, hash_of_file(file)};
    const auto project = simulation::read_checked_project(file.string());
    return {make_state(project, folder_of(file)), std::move(known), next_revision()};
}

Studio::Impl::Opened Studio::Impl::read_document(const fs::path& path) {
    const fs::path file = fs::absolute(path).lexically_normal();
    Opened saved{document_in(file)};
    const auto all = find_recoverable(options_.state_folder);
    const auto found =
        std::ranges::find_if(all, [&](const Recoverable& one) { return one.label.document == file; });
    if (found == all.end() || is_newer(file, *found)) return saved;
    auto place = AutosavePlace::take_over(found->file);
    if (!place) return saved;
    try {
        State changed = read_autosave(found->file);
        return {Document::recovered(std::move(saved.document), std::move(changed)), std::move(place)};
    } catch (const base::Error& error) {  // what lies in the file can be opened all the same
        broadcast(Json{{"event", "warning"}, {"text", error.what()}});
        return saved;
    }
}

Json Studio::Impl::recoverable_json() const {
    Json list = Json::array();
    for (const Recoverable& one : find_recoverable(options_.state_folder)) {
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(one.time.time_since_epoch());
        list.push_back({{"key", one.key},
                        {"name", one.label.name},
                        {"path", one.label.document ? Json(one.label.document->string()) : Json()},
                        {"time", seconds.count()},
                        {"tiles", one.tiles}});
    }
    return list;
}

Recoverable Studio::Impl::find(const base::JsonReader& key) const {
    for (Recoverable& one : find_recoverable(options_.state_folder)) {
        if (one.key == key.string()) return std::move(one);
    }
    throw base::InputError("this is not there any more, or another studio shows it");
}

/// Where its file is there, to undo the changes is to have what lies in it.
Studio::Impl::Opened Studio::Impl::recovered(const Recoverable& found) {
    auto place = AutosavePlace::take_over(found.file);
    if (!place) throw base::InputError("another studio shows it now");
    State changed = read_autosave(found.file);
    const auto& file = found.label.document;
    if (file && fs::exists(*file)) {
        return {Document::recovered(document_in(*file), std::move(changed)), std::move(place)};
    }
    return {Document(std::move(changed), next_revision()).named(found.label.name), std::move(place)};
}

void Studio::Impl::recover(const Request& request) {
    request.json.allow_only({"id", "do", "key", "discard"});
    Opened next = recovered(find(request.json.at("key")));
    answer(request);
    replace(request, std::move(next));
}

void Studio::Impl::recoverable(const Request& request) {
    request.json.allow_only({"id", "do"});
    answer(request, {{"recoverable", recoverable_json()}});
}

void Studio::Impl::forget(const Request& request) {
    request.json.allow_only({"id", "do", "key"});
    const Recoverable found = find(request.json.at("key"));
    if (const auto place = AutosavePlace::take_over(found.file)) autosave_.forget(found.file);
    answer(request, {{"recoverable", recoverable_json()}});
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <studio/document/document.hpp>

#include <algorithm>

namespace fretwork::studio {

std::filesystem::path folder_of(const std::optional<std::filesystem::path>& project) {
    return project ? std::filesystem::absolute(*project).parent_path() : std::filesystem::current_path();
}

std::optional<std::string> hash_of_file(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) return std::nullopt;
    return base::sha256(base::read_text_file(path));
}

Document::Document(State state, std::int64_t revision) : history_(std::move(state)), revision_(revision) {}

Document::Document(State state, ProjectFile file, std::int64_t revision)
    : Document(std::move(state), revision) {
    path_ = std::move(file.path);
    file_hash_ = std::move(file.hash);
    saved_ = now();
}

Document Document::recovered(Document saved, State changed) {
    saved.add({std::move(changed), "changes that were not saved"});
    saved.is_recovered_ = true;
    return saved;
}

DocumentStatus Document::status() const {
    return {.revision = revision_,
            .path = path_,
            .name = path_ ? path_->stem().string() : name_,
            .is_saved = is_saved(),
            .is_recovered = is_recovered_,
            .selected_load_case = selected_,
            .undo = history_.undo_label(),
            .redo = history_.redo_label()};
}

Document Document::named(std::string name) && {
    if (!name.empty()) name_ = std::move(name);
    return std::move(*this);
}

Document Document::found_elsewhere() && {
    saved_ = now();
    return std::move(*this);
}

void Document::moved() {
    ++revision_;
    const std::size_t cases = now()->load_cases->size();
    selected_ = std::min(selected_, cases == 0 ? 0 : cases - 1);
}

void Document::add(Edited edited) {
    const std::size_t before = now()->load_cases->size();
    history_.add(std::move(edited));
    moved();
    const std::size_t cases = now()->load_cases->size();
    if (cases > before) selected_ = cases - 1;  // the new one is what people want to see
}

bool Document::undo() {
    const bool is_done = history_.undo();
    if (is_done) moved();
    return is_done;
}

bool Document::redo() {
    const bool is_done = history_.redo();
    if (is_done) moved();
    return is_done;
}

void Document::select_load_case(std::size_t index) {
    selected_ = index;
    ++revision_;
}

void Document::saved_as(const std::filesystem::path& path, std::string hash) {
    path_ = path;
    file_hash_ = std::move(hash);
    saved_ = now();
    is_recovered_ = false;
    ++revision_;
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/sha256.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/internal/project_json.hpp>
#include <fretwork/simulation/project/project_file.hpp>
#include <studio/document/autosave.hpp>

#include <algorithm>
#include <fstream>
#include <utility>

namespace fretwork::studio {
namespace {

namespace fs = std::filesystem;
using base::Json;
using base::JsonReader;

constexpr std::chrono::milliseconds kPause{500};
constexpr int kMostPlaces = 1000;
constexpr const char* kFormat = "fretwork/autosave/1";

std::string stem_of(const std::optional<fs::path>& document) {
    constexpr std::size_t kNameDigits = 16;
    return document ? base::sha256(document->string()).substr(0, kNameDigits) : std::string("untitled");
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw base::IoError(folder.string(), "", "the folder cannot be made: " + error.message());
}

/// Nothing if another studio holds it.
std::optional<base::FileLock> try_lock(const fs::path& file) {
    const auto lock = fs::path(file).replace_extension(".lock");
    std::ofstream(lock, std::ios::app).close();  // what is locked must be there
    return base::FileLock::try_lock(lock);
}

std::string text_of(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The project's text is put in as it is: it is long.
std::string autosave_text(const State& state, const AutosaveLabel& label, const fs::path& file) {
    const Json path = base::or_null(label.document);
    return "{\"format\": \"" + std::string(kFormat) + "\", \"name\": " + text_of(label.name) +
           ", \"document\": " + text_of(path) + ", \"tiles\": " + std::to_string(state.tile_count()) +
           ", \"project\": " + simulation::project_text(make_project(state, file.parent_path())) + "}\n";
}

void expect_autosave(const JsonReader& json) {
    json.expect_format("autosave");
    json.allow_only({"format", "name", "document", "tiles", "project"});
}

std::size_t tiles_of(const JsonReader& json) {
    return static_cast<std::size_t>(json.at("tiles").integer(0, 1LL << 40));
}

AutosaveLabel label_of(const JsonReader& json) {
    AutosaveLabel label{.name = json.at("name").string()};
    const JsonReader document = json.at("document");
    if (!document.is_null()) label.document = document.string();
    return label;
}

Recoverable read_label(const fs::path& file) {
    const JsonReader json = JsonReader::from_file(file);
    expect_autosave(json);
    return {.key = file.stem().string(),
            .file = file,
            .label = label_of(json),
            .time = std::chrono::file_clock::to_sys(fs::last_write_time(file)),
            .tiles = tiles_of(json)};
}

}  // namespace

AutosavePlace::AutosavePlace(const fs::path& folder, const std::optional<fs::path>& document) {
    make_folder(folder);
    const std::string stem = stem_of(document);
    for (int number = 1; number <= kMostPlaces && !lock_; ++number) {
        file_ = folder / ((number == 1 ? stem : stem + "-" + std::to_string(number)) + ".json");
        // An existing file has unsaved work that a studio left behind, and must not be lost.
        if (!fs::exists(file_)) lock_ = try_lock(file_);
    }
    if (!lock_)
        throw base::IoError(folder.string(), "",
                            std::to_string(kMostPlaces) +
                                " unsaved states of this document lie here already: recover or drop some");
}

std::optional<AutosavePlace> AutosavePlace::take_over(const fs::path& file) {
    auto lock = try_lock(file);
    if (!lock) return std::nullopt;
    return AutosavePlace(file, std::move(*lock));
}

std::vector<Recoverable> find_recoverable(const fs::path& folder) {
    std::vector<Recoverable> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (entry.path().extension() != ".json") continue;
        try {
            if (try_lock(entry.path())) found.push_back(read_label(entry.path()));
        } catch (const base::Error&) {
            continue;  // no autosave, or one of another version
        } catch (const fs::filesystem_error&) {
            continue;  // gone meanwhile
        }
    }
    std::ranges::sort(found, std::greater(), &Recoverable::time);
    return found;
}

simulation::Project parse_autosave(std::string_view text, const std::string& source) {
    const JsonReader json = JsonReader::from_text(text, source);
    expect_autosave(json);
    (void)label_of(json);
    (void)tiles_of(json);
    return simulation::read_project(json.at("project"));
}

State read_autosave(const fs::path& file) {
    return make_state(parse_autosave(base::read_text_file(file), file.string()), file.parent_path());
}

Autosave::Autosave(std::function<void(const std::string& error)> failed)
    : failed_(std::move(failed)), thread_([this](const std::stop_token& ending) { run(ending); }) {}

Autosave::~Autosave() {
    thread_.request_stop();
}

void Autosave::keep(StatePtr state, AutosaveLabel label, fs::path file) {
    const std::scoped_lock lock(mutex_);
    waiting_[std::move(file)] = {std::move(state), std::move(label)};
    changed_.notify_one();
}

void Autosave::forget(const fs::path& file) {
    {
        const std::scoped_lock lock(mutex_);
        waiting_.erase(file);
    }
    const std::scoped_lock lock(writing_);  // waits until a state that was taken is written
    std::error_code gone;
    fs::remove(file, gone);
}

void Autosave::run(const std::stop_token& ending) {
    while (true) {
        Waiting kept;
        std::unique_lock writing(writing_, std::defer_lock);
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, ending, [this] { return !waiting_.empty(); });
            if (waiting_.empty()) return;
            kept = std::exchange(waiting_, {});
            writing.lock();
        }
        for (const auto& one : kept) write(one);
        writing.unlock();
        std::unique_lock lock(mutex_);
        (void)changed_.wait_for(lock, ending, kPause, [] { return false; });
    }
}

void Autosave::write(const Waiting::value_type& kept) {
    const auto& [file, what] = kept;
    try {
        base::write_file_atomically(file, autosave_text(*what.state, what.label, file));
    } catch (...) {
        failed_(base::handled_failure().text);
    }
}

}  // namespace fretwork::studio

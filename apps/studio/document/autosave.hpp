// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/files/file_lock.hpp>
#include <studio/document/state.hpp>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace fretwork::studio {

/// The document of an autosave.
struct AutosaveLabel {
    std::string name;
    std::optional<std::filesystem::path> document{};  ///< its file; none: it was never saved
};

/// A file for the unsaved state of one document, in a folder of the studio's own. No other studio writes to
/// it while this object lives.
class AutosavePlace {
  public:
    /// Take a place that no studio holds and that has no file. Makes the folder. Throws IoError, or
    /// InputError if the place's lock file cannot be opened.
    ///
    /// @param document  the document's file; none: it was never saved
    AutosavePlace(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& document);
    /// The place of an autosave that was left behind; nothing if another studio has it.
    static std::optional<AutosavePlace> take_over(const std::filesystem::path& file);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  private:
    AutosavePlace(std::filesystem::path file, base::FileLock lock)
        : file_(std::move(file)), lock_(std::move(lock)) {}
    std::filesystem::path file_;
    std::optional<base::FileLock> lock_;
};

/// An autosave that a studio left behind. That studio has ended, or shows another document.
struct Recoverable {
    std::string key;  ///< names it within its folder
    std::filesystem::path file;
    AutosaveLabel label;
    std::chrono::system_clock::time_point time;  ///< of the last change
    std::size_t tiles = 0;
};
/// All autosaves of a folder, the newest first, without unreadable ones and without those of documents that a
/// studio shows now.
std::vector<Recoverable> find_recoverable(const std::filesystem::path& folder);

/// The project in the text of an autosave, whose other keys are checked. Throws InputError with its place.
simulation::Project parse_autosave(std::string_view text, const std::string& source);
/// The state that lies in an autosave. Throws InputError if it cannot be read.
State read_autosave(const std::filesystem::path& file);

/// Writes the newest state of a document within half a second, on its own thread: a crash loses no more than
/// that. Files are replaced whole.
class Autosave {
  public:
    /// `failed` receives, on the thread, why a state could not be written.
    explicit Autosave(std::function<void(const std::string& error)> failed);
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;
    /// Writes the waiting states.
    ~Autosave();

    void keep(StatePtr state, AutosaveLabel label, std::filesystem::path file);
    /// The document is saved, or given up: remove the autosave `file`, and forget the waiting state.
    void forget(const std::filesystem::path& file);

  private:
    struct Kept {
        StatePtr state;
        AutosaveLabel label;
    };
    using Waiting = std::map<std::filesystem::path, Kept>;
    void run(const std::stop_token& ending);
    void write(const Waiting::value_type& kept);

    std::function<void(const std::string&)> failed_;
    std::mutex mutex_;    ///< of waiting_
    std::mutex writing_;  ///< of the files
    std::condition_variable_any changed_;
    Waiting waiting_;  ///< by file
    std::jthread thread_;
};

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "state.hpp"

#include <fretwork/base/file_lock.hpp>

#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace fretwork::studio {

/// Where the unsaved state of one document is kept, in a folder of the studio's own: a file named after the
/// document's path, that no other studio writes to while this object lives.
class AutosavePlace {
  public:
    /// @param document  its file; none: a document that was never saved
    /// Makes the folder. Throws IoError. Where another studio has the document open, this is a place beside.
    AutosavePlace(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& document);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  private:
    std::filesystem::path file_;
    std::optional<base::FileLock> lock_;
};

/// Writes the newest state of a document within half a second, in a thread of its own: a crash loses no more
/// than that. Files are replaced whole.
class Autosave {
  public:
    /// `failed` is told, on the thread, why a state could not be written.
    explicit Autosave(std::function<void(const std::string& error)> failed);
    Autosave(const Autosave&) = delete;
    Autosave& operator=(const Autosave&) = delete;
    /// Writes what waits.
    ~Autosave();

    void keep(StatePtr state, std::filesystem::path file);
    /// The document is saved: remove its file. What waits for it is forgotten.
    void forget(const std::filesystem::path& file);

  private:
    struct Kept {
        StatePtr state;
        std::filesystem::path file;
    };
    void run(const std::stop_token& ending);
    void write(const Kept& kept);

    std::function<void(const std::string&)> failed_;
    std::mutex mutex_;    ///< of waiting_
    std::mutex writing_;  ///< of the files
    std::condition_variable_any changed_;
    std::optional<Kept> waiting_;
    std::jthread thread_;
};

}  // namespace fretwork::studio

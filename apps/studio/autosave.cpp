// SPDX-License-Identifier: GPL-3.0-or-later
#include "autosave.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/file.hpp>
#include <fretwork/base/sha256.hpp>
#include <fretwork/simulation/project_file.hpp>

#include <chrono>
#include <fstream>

namespace fretwork::studio {
namespace {

constexpr std::chrono::milliseconds kPause{500};
constexpr int kMostStudios = 100;

std::string stem_of(const std::optional<std::filesystem::path>& document) {
    constexpr std::size_t kDigits = 16;
    return document ? base::sha256(document->string()).substr(0, kDigits) : std::string("untitled");
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw base::IoError(folder.string() + ": the folder cannot be made: " + error.message());
}

}  // namespace

AutosavePlace::AutosavePlace(const std::filesystem::path& folder,
                             const std::optional<std::filesystem::path>& document) {
    make_folder(folder);
    const std::string stem = stem_of(document);
    for (int number = 1; number <= kMostStudios && !lock_; ++number) {
        const std::string name = number == 1 ? stem : stem + "-" + std::to_string(number);
        const auto lock = folder / (name + ".lock");
        std::ofstream(lock, std::ios::app).close();  // what is locked must be there
        lock_ = base::FileLock::try_lock(lock);
        file_ = folder / (name + ".json");
    }
    if (!lock_)
        throw base::IoError(folder.string() + ": " + std::to_string(kMostStudios) +
                            " studios have this document open already");
}

Autosave::Autosave(std::function<void(const std::string& error)> failed)
    : failed_(std::move(failed)), thread_([this](const std::stop_token& ending) { run(ending); }) {}

Autosave::~Autosave() {
    thread_.request_stop();
}

void Autosave::keep(StatePtr state, std::filesystem::path file) {
    const std::scoped_lock lock(mutex_);
    waiting_ = {std::move(state), std::move(file)};
    changed_.notify_one();
}

void Autosave::forget(const std::filesystem::path& file) {
    {
        const std::scoped_lock lock(mutex_);
        if (waiting_ && waiting_->file == file) waiting_.reset();
    }
    const std::scoped_lock lock(writing_);  // not between a state that was taken and its file
    std::error_code gone;
    std::filesystem::remove(file, gone);
}

void Autosave::run(const std::stop_token& ending) {
    while (true) {
        Kept kept;
        std::unique_lock writing(writing_, std::defer_lock);
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, ending, [this] { return waiting_.has_value(); });
            if (!waiting_) return;
            kept = std::move(*waiting_);
            waiting_.reset();
            writing.lock();
        }
        write(kept);
        writing.unlock();
        std::unique_lock lock(mutex_);
        (void)changed_.wait_for(lock, ending, kPause, [] { return false; });
    }
}

void Autosave::write(const Kept& kept) {
    try {
        base::write_file_atomically(
            kept.file, simulation::project_text(make_project(*kept.state, kept.file.parent_path())));
    } catch (const base::Error& error) {
        failed_(error.what());
    }
}

}  // namespace fretwork::studio

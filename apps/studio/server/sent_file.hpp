// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/scratch.hpp>
#include <fretwork/base/json_reader.hpp>

#include <filesystem>
#include <string>

namespace fretwork::studio {

/// A file that comes in a message.
struct SentFile {
    std::string name;  ///< its ending says what kind of file it is
    std::string content{};
};

/// The keys `name` and `text_base64` of an object; which others it may have is for the caller to say.
SentFile parse_sent_file(const base::JsonReader& json);

/// A sent file on this machine's disk, as long as this lives.
class FileOnDisk {
  public:
    explicit FileOnDisk(const SentFile& sent);
    [[nodiscard]] std::filesystem::path path() const;
    /// As the file was called where it was sent, fit to be shown.
    [[nodiscard]] const std::string& name() const { return shown_; }

  private:
    std::string shown_;
    std::string ending_;
    base::Scratch folder_;
};

/// The value of `read` at the path of a sent file. Errors name the file as it was sent.
template <class Read>
auto read_sent(const SentFile& sent, const Read& read) {
    const FileOnDisk file(sent);
    try {
        return read(file.path());
    } catch (const base::GeometryError& error) {
        throw base::renamed(error, file.path().string(), file.name());
    } catch (const base::InputError& error) {
        throw base::renamed(error, file.path().string(), file.name());
    }
}

}  // namespace fretwork::studio

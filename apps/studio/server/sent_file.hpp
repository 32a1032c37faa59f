// SPDX-License-Identifier: GPL-3.0-or-later
// Names, paths and files that come in messages.
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
    friend bool operator==(const SentFile&, const SentFile&) = default;
};

/// The keys `name` and `text_base64` of an object. The caller checks that it has no other keys.
SentFile parse_sent_file(const base::JsonReader& json);

/// A sent file on this machine's disk, as long as this lives.
class FileOnDisk {
  public:
    explicit FileOnDisk(const SentFile& sent);
    [[nodiscard]] std::filesystem::path path() const;
    /// The name of the file at its sender, shortened and printable.
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

/// A text without the character NUL, at which the system would end a path.
std::string read_plain_text(const base::JsonReader& json);

/// A name, printable and shortened to 60 characters, for messages.
std::string shown_name(const std::string& name);

/// A name of the program's own, or the path of a file. Throws InputError if it is longer than any path.
std::string read_name_or_path(const base::JsonReader& json);

/// The absolute path of a file on this machine, which need not be there. Throws InputError if the system can
/// have no such file.
std::filesystem::path read_path(const base::JsonReader& json);

/// The name of a file on the page's machine: not empty, and at most 255 bytes, as file systems have it.
std::string read_file_name(const base::JsonReader& json);

}  // namespace fretwork::studio

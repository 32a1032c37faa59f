// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as a file, for readers that take a path.
#pragma once

#include <fretwork/base/error.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace fretwork::fuzz {

/// A folder for the inputs of this process, which vanishes with it.
class InputFolder {
  public:
    InputFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "fretwork-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw base::IoError("no temporary folder can be made");
        path_ = name;
    }
    InputFolder(const InputFolder&) = delete;
    InputFolder& operator=(const InputFolder&) = delete;
    ~InputFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// The file of the last input with a name. Its ending says to the program what kind of file it is.
inline std::filesystem::path input_file(const std::string& name, std::string_view bytes) {
    static const InputFolder folder;
    std::filesystem::path path = folder.path() / name;
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return path;
}

}  // namespace fretwork::fuzz

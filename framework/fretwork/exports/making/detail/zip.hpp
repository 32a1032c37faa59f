// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace fretwork::exports::detail {

struct ZipEntry {
    std::string name;
    std::string content;
    enum class Kind { Stored, Compressed } kind = Kind::Compressed;
};

/// A ZIP archive with the entries in their order. The same entries give the same bytes. Throws IoError.
std::string zip_archive(const std::vector<ZipEntry>& entries);

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/mechanics/frame/frame.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace fretwork::mechanics {

/// Parse the text of a frame file. The frame returned is valid. Throws InputError that names `source` and a
/// place in the text.
Frame parse_frame(std::string_view text, const std::string& source);
/// The text of a frame file; parse_frame gives an equal frame. A material or section of several beams is
/// written once.
std::string frame_text(const Frame& frame);

/// Read a frame file. Throws as parse_frame.
Frame read_frame(const std::filesystem::path& path);
/// Write a frame file atomically. Throws IoError.
void write_frame(const Frame& frame, const std::filesystem::path& path);

}  // namespace fretwork::mechanics

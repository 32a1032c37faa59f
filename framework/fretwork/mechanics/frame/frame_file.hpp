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
/// The text of a frame file; if the frame is valid, parse_frame gives an equal frame, except for shapes that
/// files do not store (Section::shape). A material or section of several beams is written once. Throws
/// NumericalError if a number is not finite.
std::string frame_text(const Frame& frame);

/// Read a frame file. Throws as parse_frame.
Frame read_frame(const std::filesystem::path& path);
/// Write a frame file atomically. Throws as frame_text(), or IoError.
void write_frame(const Frame& frame, const std::filesystem::path& path);

}  // namespace fretwork::mechanics

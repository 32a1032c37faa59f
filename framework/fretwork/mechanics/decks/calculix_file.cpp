// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/decks/detail/deck_reader.hpp>
#include <fretwork/mechanics/decks/detail/deck_writer.hpp>

namespace fretwork::mechanics {

LabelledFrame parse_calculix(std::string_view text, const std::string& source) {
    return decks::frame_of(decks::InputDeck(text, source));
}

std::string calculix_text(const Frame& frame, DeckProgram program) {
    return decks::deck_text(frame, program);
}

LabelledFrame read_calculix(const std::filesystem::path& path) {
    return parse_calculix(base::read_text_file(path), path.string());
}

void write_calculix(const Frame& frame, const std::filesystem::path& path) {
    base::write_file_atomically(path, calculix_text(frame));
}

}  // namespace fretwork::mechanics

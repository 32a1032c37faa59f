// SPDX-License-Identifier: GPL-3.0-or-later
// Every reader of files and messages that come from strangers, for the fuzzer and for the replay of its
// inputs.
#pragma once

#include <span>
#include <string_view>

namespace fretwork::fuzz {

/// A reader of bytes from a stranger.
struct Reader {
    std::string_view name;  ///< also the folder of its corpus
    /// Reads the bytes as the program reads a file or a message. Throws base::Error if they are refused.
    void (*read)(std::string_view bytes);
};

/// All readers.
std::span<const Reader> readers();
/// The reader with a name; null if there is none.
const Reader* find_reader(std::string_view name);

/// Whether a reader took the bytes or refused them.
enum class Answer { Taken, Refused };
/// Read the bytes, as often as wanted. Only base::Error is an answer: any other exception, a signal and a
/// broken promise (see promises.hpp) is a finding, and ends the program.
Answer feed(const Reader& reader, std::string_view bytes);

// outline_readers.cpp: drawings and meshes
void read_svg(std::string_view bytes);
void read_dxf(std::string_view bytes);
void read_obj(std::string_view bytes);
void read_ply(std::string_view bytes);
void read_off(std::string_view bytes);
void read_outline(std::string_view bytes);

// json_readers.cpp: the kinds of JSON that the program writes or takes
void read_autosave(std::string_view bytes);
void read_beams(std::string_view bytes);
void read_facts(std::string_view bytes);
void read_frame(std::string_view bytes);
void read_layout(std::string_view bytes);
void read_load_case(std::string_view bytes);
void read_painting(std::string_view bytes);
void read_project(std::string_view bytes);
void read_result(std::string_view bytes);
void read_scenario(std::string_view bytes);
void read_setting(std::string_view bytes);
void read_stages(std::string_view bytes);
void read_target(std::string_view bytes);

// other_readers.cpp: decks, images, libraries, and what people type
void read_deck(std::string_view bytes);
void read_image(std::string_view bytes);
void read_library(std::string_view bytes);
void read_expression(std::string_view bytes);
void read_query(std::string_view bytes);

// studio_readers.cpp: what a page sends
void read_edit(std::string_view bytes);
void read_design_request(std::string_view bytes);
void read_new_request(std::string_view bytes);
void read_web_target(std::string_view bytes);

// server_readers.cpp: servers that run
void read_wire(std::string_view bytes);
void read_conversation(std::string_view bytes);

}  // namespace fretwork::fuzz

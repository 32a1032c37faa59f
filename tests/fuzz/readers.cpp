// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/promises.hpp"
#include "fuzz/readers.hpp"

#include <fretwork/base/error.hpp>

#include <algorithm>

namespace fretwork::fuzz {
namespace {

constexpr Reader kReaders[] = {{"svg", read_svg},
                               {"dxf", read_dxf},
                               {"obj", read_obj},
                               {"ply", read_ply},
                               {"off", read_off},
                               {"outline", read_outline},
                               {"autosave", read_autosave},
                               {"beams", read_beams},
                               {"facts", read_facts},
                               {"frame", read_frame},
                               {"layout", read_layout},
                               {"load-case", read_load_case},
                               {"painting", read_painting},
                               {"project", read_project},
                               {"result", read_result},
                               {"scenario", read_scenario},
                               {"setting", read_setting},
                               {"stages", read_stages},
                               {"target", read_target},
                               {"deck", read_deck},
                               {"image", read_image},
                               {"library", read_library},
                               {"expression", read_expression},
                               {"query", read_query},
                               {"studio-edit", read_edit},
                               {"studio-design", read_design_request},
                               {"studio-new", read_new_request},
                               {"studio-address", read_web_target},
                               {"studio-wire", read_wire},
                               {"studio-talk", read_conversation}};

}  // namespace

std::span<const Reader> readers() {
    return kReaders;
}

const Reader* find_reader(std::string_view name) {
    const auto found = std::ranges::find(kReaders, name, &Reader::name);
    return found == std::end(kReaders) ? nullptr : found;
}

Answer feed(const Reader& reader, std::string_view bytes) {
    try {
        reader.read(bytes);
        return Answer::Taken;
    } catch (const base::Error& error) {
        promise(!std::string_view(error.what()).empty(), "a refusal says why", bytes);
        return Answer::Refused;
    }
}

}  // namespace fretwork::fuzz

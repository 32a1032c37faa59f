// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bind.hpp"
#include "surfaces/painting_choices.hpp"

#include <typed/painting_text.hpp>

namespace fretwork::python {
namespace {

using namespace simulation;

std::string text_of(const py::object& given) {
    return given.is_none() ? std::string() : given.cast<std::string>();
}

/// Ids with commas between, also from a list of them.
std::string palette_of(const py::object& given) {
    if (given.is_none() || py::isinstance<py::str>(given)) return text_of(given);
    std::string joined;
    for (const auto& id : given.cast<std::vector<std::string>>()) joined += (joined.empty() ? "" : ",") + id;
    return joined;
}

struct Reader {
    py::dict& named;

    PaintingChoice operator()(const std::string& text) const {
        typed::PaintingText typed_text{.patterns = text, .prefix = ""};
        typed_text.palette = palette_of(taken(named, "palette"));
        typed_text.property = text_of(taken(named, "property"));
        typed_text.range = text_of(taken(named, "range"));
        const py::object dither = taken(named, "dither");
        typed_text.dither = !dither.is_none() && dither.cast<bool>();
        return typed::read_painting(typed_text);
    }
    PaintingChoice operator()(const std::vector<std::string>& ids) const {
        if (ids.size() == 1) return PaintOnePattern{ids.front()};
        return PaintAtRandom{.palette = {.ids = ids}};
    }
    template <class Choice>
    PaintingChoice operator()(const Choice& choice) const {
        return choice;
    }
};

}  // namespace

PaintingChoice painting_choice(const PaintingGiven& given, py::dict& named) {
    return std::visit(Reader{named}, given);
}

}  // namespace fretwork::python

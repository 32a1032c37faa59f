// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/design/design_warning.hpp>

#include <numbers>

namespace fretwork::design {

std::string plain_text(const WarnedValue& value) {
    constexpr int kDigits = 4;
    if (value.quantity == WarnedValue::Quantity::Length)
        return base::format_number(1e3 * value.value, kDigits) + " mm";
    return base::format_number(180.0 / std::numbers::pi * value.value, kDigits) + " deg";
}

std::string plain_text(const DesignWarning& warning) {
    std::string text = warning.text;
    for (std::size_t i = 0; i < warning.values.size(); ++i) {
        const std::string mark = "{" + std::to_string(i) + "}";
        const auto place = text.find(mark);
        if (place != std::string::npos) text.replace(place, mark.size(), plain_text(warning.values[i]));
    }
    return text;
}

std::vector<std::string> plain_texts(std::span<const DesignWarning> warnings) {
    std::vector<std::string> texts;
    for (const DesignWarning& own : warnings) texts.push_back(plain_text(own));
    return texts;
}

}  // namespace fretwork::design

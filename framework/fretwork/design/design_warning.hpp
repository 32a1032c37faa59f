// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace fretwork::design {

/// A length or an angle in the text of a warning, in SI. Programs may show it in other units.
struct WarnedValue {
    /// The kind of the number.
    enum class Quantity { Length, Angle };
    double value = 0.0;                    ///< number, m or rad
    Quantity quantity = Quantity::Length;  ///< kind of the number
};

/// One warning about a design, such as a goal that nodes cannot reach.
struct DesignWarning {
    std::string text;  ///< one line without a full stop; "{0}" stands for the first of `values`, and so on
    bool factor_may_help = false;       ///< true if a free factor on the loads may help
    std::vector<WarnedValue> values{};  ///< the values of the placeholders "{0}", "{1}", .. in `text`
};

/// The text of a value, in millimetres or degrees, with its unit.
std::string plain_text(const WarnedValue& value);
/// The text of a warning, with each placeholder replaced by its value in millimetres or degrees.
std::string plain_text(const DesignWarning& warning);
/// The texts of warnings, with their values in millimetres and degrees.
std::vector<std::string> plain_texts(std::span<const DesignWarning> warnings);

}  // namespace fretwork::design

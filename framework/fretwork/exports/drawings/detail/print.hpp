// SPDX-License-Identifier: GPL-3.0-or-later
// How wide drawings are printed, and how high their text is.
#pragma once

namespace fretwork::exports::detail {

/// Widths of a journal's column and page, m.
inline constexpr double kColumnWidth = 0.084;
inline constexpr double kPageWidth = 0.177;

/// The smallest text in print, m: 6 pt.
inline constexpr double kSmallestPrint = 6.0 / 72.0 * 0.0254;

/// The height of text in a drawing of some width, so that it is just legible (and not rounded below that)
/// when the drawing is printed as wide as `print`. All lengths in metres.
constexpr double legible_height(double drawing_width, double print) {
    return 1.02 * kSmallestPrint * drawing_width / print;
}

/// The printed width of a sheet of equal cells, and the smallest height of its text. All lengths in metres.
struct SheetPrint {
    double width = 0.0;  ///< width in print; 0: a poster, which may have any width
    double text = 0.0;   ///< height of text in the drawing
};

/// The print of a sheet with `columns` columns of cells, each `cell` wide. Up to five columns are printed in
/// a journal's column, and up to twelve on a page. A poster has the text height of a page of twelve columns.
constexpr SheetPrint sheet_print(int columns, double cell) {
    constexpr int kMostInColumn = 5;
    constexpr int kMostOnPage = 12;
    if (columns <= kMostInColumn) return {kColumnWidth, legible_height(columns * cell, kColumnWidth)};
    if (columns <= kMostOnPage) return {kPageWidth, legible_height(columns * cell, kPageWidth)};
    return {0.0, legible_height(kMostOnPage * cell, kPageWidth)};
}

}  // namespace fretwork::exports::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/exports/making/detail/dxf_text.hpp>

#include <charconv>

namespace fretwork::exports::detail {

DxfText& DxfText::group(int code, std::string_view value) {
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
    return *this;
}

DxfText& DxfText::group(int code, int value) {
    return group(code, std::to_string(value));
}

DxfText& DxfText::number(int code, double value) {
    std::string text;
    append_rounded(text, value);
    return group(code, text);
}

DxfText& DxfText::exact(int code, double value) {
    return group(code, base::format_number(value));
}

DxfText& DxfText::length(int code, double metres) {
    return number(code, 1e3 * metres);
}

DxfText& DxfText::point(const geometry::Point2& place) {
    return length(10, place.x).length(20, place.y);
}

DxfText& DxfText::point(const geometry::Point2& place, double z) {
    return point(place).length(30, z);
}

DxfText& DxfText::second_point(const geometry::Point2& place, double z) {
    return length(11, place.x).length(21, place.y).length(31, z);
}

DxfText& DxfText::comment(std::string_view text) {
    return group(999, text);
}

DxfText& DxfText::variable(std::string_view name) {
    return group(9, name);
}

std::string DxfText::next_handle() const {
    char buffer[16];
    const auto result = std::to_chars(buffer, buffer + sizeof(buffer), handles_, 16);
    std::string text(buffer, result.ptr);
    for (char& c : text) c = c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
    return text;
}

std::string DxfText::handle() {
    std::string text = next_handle();
    ++handles_;
    group(5, text);
    return text;
}

std::string DxfText::record(std::string_view type, std::string_view subclass, std::string_view name) {
    group(0, type);
    std::string own = handle();
    group(330, table_).group(100, "AcDbSymbolTableRecord").group(100, subclass).group(2, name);
    return own;
}

}  // namespace fretwork::exports::detail

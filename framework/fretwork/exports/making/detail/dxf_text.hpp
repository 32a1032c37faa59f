// SPDX-License-Identifier: GPL-3.0-or-later
// The groups of a DXF file: a code in a line, its value in the next.
#pragma once

#include <fretwork/exports/making/detail/millimetres.hpp>
#include <fretwork/geometry/polygon.hpp>

#include <string>
#include <string_view>

namespace fretwork::exports::detail {

class DxfText {
  public:
    DxfText& group(int code, std::string_view value);
    DxfText& group(int code, int value);
    /// A plain number, rounded to 1e-6.
    DxfText& number(int code, double value);
    /// A number with all of its digits.
    DxfText& exact(int code, double value);
    /// A length, m; the file has millimetres.
    DxfText& length(int code, double metres);
    DxfText& point(const geometry::Point2& place);
    DxfText& point(const geometry::Point2& place, double z);
    DxfText& second_point(const geometry::Point2& place, double z);
    DxfText& comment(std::string_view text);
    DxfText& variable(std::string_view name);

    /// Assigns and returns a new handle.
    std::string handle();
    /// The handle that handle() assigns next.
    [[nodiscard]] std::string next_handle() const;
    /// Begin a record of a table. Returns its handle.
    std::string record(std::string_view type, std::string_view subclass, std::string_view name);

    template <class Body>
    void section(std::string_view name, const Body& body) {
        group(0, "SECTION").group(2, name);
        body();
        group(0, "ENDSEC");
    }
    template <class Body>
    void table(std::string_view name, int records, const Body& body) {
        group(0, "TABLE").group(2, name);
        table_ = handle();
        group(330, "0").group(100, "AcDbSymbolTable").group(70, records);
        if (name == "DIMSTYLE") group(100, "AcDbDimStyleTable");
        body();
        group(0, "ENDTAB");
    }

    [[nodiscard]] std::string take() && { return std::move(text_); }

  private:
    std::string text_;
    std::string table_;
    int handles_ = 0x20;
};

}  // namespace fretwork::exports::detail

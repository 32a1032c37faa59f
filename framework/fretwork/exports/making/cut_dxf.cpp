// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/making/detail/dxf_text.hpp>
#include <fretwork/exports/making/making_files.hpp>

#include <array>

namespace fretwork::exports {
namespace {

using detail::DxfText;
using fabrication::Contour;
using fabrication::CutSheet;
using fabrication::Label;
using geometry::Box;

/// Layers and their colours (AutoCAD's numbers: 1 red, 5 blue, 7 black or white, 8 grey).
struct Layer {
    const char* name;
    int colour;
};
constexpr std::array<Layer, 5> kLayers = {
    {{"0", 7}, {"cut", 1}, {"engrave", 7}, {"labels", 5}, {"guides", 8}}};

/// Writes the sections of a file in their order. Handles must be unique; elements name their owners' handles.
class CutDxf {
  public:
    explicit CutDxf(const CutSheet& sheet) : sheet_(sheet) {}

    [[nodiscard]] std::string text() && {
        out_.comment(std::string(base::kMadeBy) + ": lengths in millimetres at true scale");
        header();
        out_.section("CLASSES", [] {});
        tables();
        blocks();
        out_.section("ENTITIES", [&] { entities(); });
        objects();
        out_.group(0, "EOF");
        return std::move(out_).take();
    }

  private:
    void header() {
        const Box box = box_of(sheet_);
        out_.section("HEADER", [&] {
            out_.variable("$ACADVER").group(1, "AC1015");
            out_.variable("$INSUNITS").group(70, 4);     // millimetres
            out_.variable("$MEASUREMENT").group(70, 1);  // metric
            out_.variable("$LUNITS").group(70, 2);       // decimal
            out_.variable("$HANDSEED").group(5, "FFFFFF");
            out_.variable("$EXTMIN").point({box.xmin, box.ymin});
            out_.variable("$EXTMAX").point({box.xmax, box.ymax});
        });
    }

    void tables() {
        out_.section("TABLES", [&] {
            out_.table("VPORT", 0, [] {});
            out_.table("LTYPE", 3, [&] {
                for (const char* name : {"ByBlock", "ByLayer", "Continuous"}) {
                    out_.record("LTYPE", "AcDbLinetypeTableRecord", name);
                    out_.group(70, 0).group(3, "").group(72, 65).group(73, 0).number(40, 0.0);
                }
            });
            out_.table("LAYER", static_cast<int>(kLayers.size()), [&] {
                for (const Layer& layer : kLayers) {
                    out_.record("LAYER", "AcDbLayerTableRecord", layer.name);
                    out_.group(70, 0).group(62, layer.colour).group(6, "Continuous");
                }
            });
            out_.table("STYLE", 1, [&] {
                out_.record("STYLE", "AcDbTextStyleTableRecord", "Standard");
                out_.group(70, 0).number(40, 0.0).number(41, 1.0).number(50, 0.0).group(71, 0);
                out_.number(42, 2.5).group(3, "txt").group(4, "");
            });
            out_.table("VIEW", 0, [] {});
            out_.table("UCS", 0, [] {});
            out_.table("APPID", 1, [&] {
                out_.record("APPID", "AcDbRegAppTableRecord", "ACAD");
                out_.group(70, 0);
            });
            out_.table("DIMSTYLE", 0, [] {});
            out_.table("BLOCK_RECORD", 2, [&] {
                model_space_ = out_.record("BLOCK_RECORD", "AcDbBlockTableRecord", "*Model_Space");
                paper_space_ = out_.record("BLOCK_RECORD", "AcDbBlockTableRecord", "*Paper_Space");
            });
        });
    }

    void block(const char* name, const std::string& owner) {
        out_.group(0, "BLOCK").handle();
        out_.group(330, owner).group(100, "AcDbEntity").group(8, "0").group(100, "AcDbBlockBegin");
        out_.group(2, name).group(70, 0).point({0.0, 0.0}).group(3, name).group(1, "");
        out_.group(0, "ENDBLK").handle();
        out_.group(330, owner).group(100, "AcDbEntity").group(8, "0").group(100, "AcDbBlockEnd");
    }
    void blocks() {
        out_.section("BLOCKS", [&] {
            block("*Model_Space", model_space_);
            block("*Paper_Space", paper_space_);
        });
    }

    void entities() {
        for (const fabrication::Piece& piece : sheet_.pieces) {
            contour(piece.outer, "cut");
            for (const Contour& opening : piece.openings) contour(opening, "cut");
        }
        for (const Label& label : sheet_.engraved) text(label, "engrave");
        for (const Label& label : sheet_.labels) text(label, "labels");
        for (const Contour& guide : sheet_.guides) contour(guide, "guides");
    }
    void entity(const char* type, const char* layer) {
        out_.group(0, type).handle();
        out_.group(330, model_space_).group(100, "AcDbEntity").group(8, layer);
    }
    void contour(const Contour& contour, const char* layer) {
        entity("LWPOLYLINE", layer);
        constexpr int kClosed = 1;
        out_.group(100, "AcDbPolyline").group(90, static_cast<int>(contour.size())).group(70, kClosed);
        for (const fabrication::ContourPoint& point : contour) {
            out_.point(point.place);
            if (point.bulge != 0.0) out_.exact(42, point.bulge);
        }
    }
    void text(const Label& label, const char* layer) {
        constexpr int kCenter = 1;
        constexpr int kMiddle = 2;
        entity("TEXT", layer);
        out_.group(100, "AcDbText").point(label.place, 0.0).length(40, label.height).group(1, label.text);
        out_.group(72, kCenter).second_point(label.place, 0.0).group(100, "AcDbText").group(73, kMiddle);
    }

    void objects() {
        out_.section("OBJECTS", [&] {
            const std::string root = out_.group(0, "DICTIONARY").handle();
            out_.group(330, "0").group(100, "AcDbDictionary").group(281, 1).group(3, "ACAD_GROUP");
            out_.group(350, out_.next_handle());
            out_.group(0, "DICTIONARY").handle();
            out_.group(330, root).group(100, "AcDbDictionary").group(281, 1);
        });
    }

    const CutSheet& sheet_;
    DxfText out_;
    std::string model_space_;
    std::string paper_space_;
};

}  // namespace

std::string cut_dxf(const CutSheet& sheet) {
    return CutDxf(sheet).text();
}

}  // namespace fretwork::exports

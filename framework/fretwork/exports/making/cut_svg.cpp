// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/exports/making/detail/millimetres.hpp>
#include <fretwork/exports/making/making_files.hpp>

#include <cmath>
#include <numbers>

namespace fretwork::exports {
namespace {

using namespace detail;
using fabrication::Arc;
using fabrication::Contour;
using fabrication::ContourPoint;
using fabrication::CutSheet;
using fabrication::Label;
using geometry::Box;
using geometry::Point2;

/// SVG counts y downwards.
class CutSvg {
  public:
    explicit CutSvg(const CutSheet& sheet) : sheet_(sheet), box_(geometry::grown(box_of(sheet), kMargin)) {}

    [[nodiscard]] std::string text() && {
        begin();
        layer("guides", "stroke=\"#999999\"", [&] {
            for (const Contour& guide : sheet_.guides) path({guide, {}});
        });
        layer("labels", "fill=\"#2166ac\" stroke=\"none\"", [&] { texts(sheet_.labels); });
        layer("engrave", "fill=\"#000000\" stroke=\"none\"", [&] { texts(sheet_.engraved); });
        layer("cut", "stroke=\"#ff0000\"", [&] {
            for (const fabrication::Piece& piece : sheet_.pieces) path(piece);
        });
        text_ += "</svg>\n";
        return std::move(text_);
    }

  private:
    void begin() {
        const std::string width = millimetre_number(box_.width());
        const std::string height = millimetre_number(box_.height());
        text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- " + std::string(base::kMadeBy) +
                ": lengths in millimetres at true scale -->\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
                "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" width=\"" +
                width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height +
                "\" fill=\"none\" stroke-width=\"0.1\" font-family=\"DejaVu Sans, sans-serif\" "
                "text-anchor=\"middle\">\n<title>" +
                sheet_.title + "</title>\n";
    }

    template <class Body>
    void layer(const std::string& name, const std::string& style, const Body& body) {
        text_ += "<g id=\"" + name + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" + name + "\" " +
                 style + ">\n";
        body();
        text_ += "</g>\n";
    }

    void place(const Point2& point) {
        append_millimetres(text_, point.x - box_.xmin);
        text_ += ' ';
        append_millimetres(text_, box_.ymax - point.y);
    }

    void path(const fabrication::Piece& piece) {
        text_ += "<path d=\"";
        contour(piece.outer);
        for (const Contour& opening : piece.openings) contour(opening);
        text_ += "\"/>\n";
    }

    void contour(const Contour& contour) {
        text_ += 'M';
        place(contour.front().place);
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const ContourPoint& from = contour[i];
            const Point2& to = contour[(i + 1) % contour.size()].place;
            if (from.bulge != 0.0) {
                arc(from, to);
            } else if (i + 1 < contour.size()) {
                text_ += 'L';
                place(to);
            }
        }
        text_ += 'Z';
    }

    void arc(const ContourPoint& from, const Point2& to) {
        const Arc arc = arc_between(from, to);
        text_ += 'A';
        append_millimetres(text_, arc.radius);
        text_ += ' ';
        append_millimetres(text_, arc.radius);
        text_ += std::abs(arc.sweep) > std::numbers::pi ? " 0 1 " : " 0 0 ";
        text_ += arc.sweep > 0.0 ? "0 " : "1 ";
        place(to);
    }

    void texts(const std::vector<Label>& labels) {
        for (const Label& label : labels) {
            text_ += "<text x=\"" + millimetre_number(label.place.x - box_.xmin) + "\" y=\"" +
                     millimetre_number(box_.ymax - label.place.y + 0.35 * label.height) + "\" font-size=\"" +
                     millimetre_number(label.height) + "\">" + label.text + "</text>\n";
        }
    }

    static constexpr double kMargin = 0.002;  // m
    const CutSheet& sheet_;
    Box box_;
    std::string text_;
};

}  // namespace

std::string cut_svg(const CutSheet& sheet) {
    return CutSvg(sheet).text();
}

}  // namespace fretwork::exports

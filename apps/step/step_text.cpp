// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_text.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/files/scratch.hpp>
#include <fretwork/geometry/plane.hpp>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <filesystem>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <vector>

namespace fretwork::step {
namespace {

using fabrication::Contour;
using geometry::Point2;

constexpr double kMillimetres = 1e3;

gp_Pnt point(const Point2& place) {
    return {kMillimetres * place.x, kMillimetres * place.y, 0.0};
}

/// The middle of the arc from a corner to the next.
Point2 middle_of_arc(const fabrication::ContourPoint& from, const Point2& to) {
    const fabrication::Arc arc = fabrication::arc_between(from, to);
    const Point2 arm = from.place - arc.center;
    const double half = 0.5 * arc.sweep;
    return arc.center + Point2{std::cos(half) * arm.x - std::sin(half) * arm.y,
                               std::sin(half) * arm.x + std::cos(half) * arm.y};
}

TopoDS_Wire wire_of(const Contour& contour) {
    std::vector<TopoDS_Vertex> corners;
    for (const fabrication::ContourPoint& corner : contour)
        corners.push_back(BRepBuilderAPI_MakeVertex(point(corner.place)).Vertex());
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const std::size_t next = (i + 1) % contour.size();
        const fabrication::ContourPoint& from = contour[i];
        const Point2& to = contour[next].place;
        if (from.bulge == 0.0) {
            wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[next]).Edge());
            continue;
        }
        const GC_MakeArcOfCircle arc(point(from.place), point(middle_of_arc(from, to)), point(to));
        wire.Add(BRepBuilderAPI_MakeEdge(arc.Value(), corners[i], corners[next]).Edge());
    }
    return wire.Wire();
}

TopoDS_Shape solid_of(const fabrication::Piece& piece, double height) {
    BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), wire_of(piece.outer));
    for (const Contour& opening : piece.openings) face.Add(wire_of(opening));
    return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0.0, 0.0, kMillimetres * height)).Shape();
}

/// Stop OpenCASCADE's report of every transfer on the standard output.
void silence() {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
}

std::string written(STEPControl_Writer& writer) {
    const base::Scratch scratch(base::temporary_folder() / "solid", base::Scratch::Kind::Folder);
    const std::filesystem::path file = scratch.path() / "solid.step";
    if (writer.Write(file.c_str()) != IFSelect_RetDone)
        throw base::IoError(file.string() + ": OpenCASCADE cannot write it");
    return base::read_text_file(file);
}

/// Do the work; throws NumericalError in place of Standard_Failure, which need not be a std::exception.
template <class Work>
auto with_own_errors(const Work& work) {
    try {
        return work();
    } catch (const Standard_Failure& failure) {
        throw base::NumericalError(std::string("OpenCASCADE cannot build the solid: ") +
                                   failure.GetMessageString());
    }
}

}  // namespace

std::string step_text(const fabrication::Shape& shape, const std::string& name,
                      const base::Control& control) {
    return with_own_errors([&] {
        silence();
        STEPControl_Writer writer;
        Interface_Static::SetCVal("write.step.schema", "AP214IS");
        Interface_Static::SetCVal("write.step.unit", "MM");
        Interface_Static::SetCVal("write.step.product.name", name.c_str());
        for (const fabrication::Piece& piece : shape.pieces) {
            control.check();
            const TopoDS_Shape solid = solid_of(piece, shape.height);
            if (!BRepCheck_Analyzer(solid).IsValid())
                throw base::NumericalError("OpenCASCADE finds a piece of the outline invalid as a solid");
            if (writer.Transfer(solid, STEPControl_ManifoldSolidBrep) != IFSelect_RetDone)
                throw base::NumericalError("OpenCASCADE cannot transfer a piece of the outline to STEP");
        }
        APIHeaderSection_MakeHeader header(writer.Model());
        header.SetOriginatingSystem(new TCollection_HAsciiString(std::string(base::kMadeBy).c_str()));
        return written(writer);
    });
}

}  // namespace fretwork::step

// SPDX-License-Identifier: GPL-3.0-or-later
// Frames: sections, materials, beams, supports and loads, and their files.
#include "core/bind.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/mechanics/decks/calculix_file.hpp>
#include <fretwork/mechanics/discretization.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/solve.hpp>
#include <fretwork/mechanics/standard_gravity.hpp>

namespace fretwork::python {
namespace {

using namespace mechanics;

void bind_shapes(py::module_& m) {
    Record<RectangleShape>(m, "RectangleShape", "A rectangular bar; its width lies along local axis 2.")
        .field("width", &RectangleShape::width, "m")
        .field("height", &RectangleShape::height, "m")
        .done();
    Record<CircleShape>(m, "CircleShape", "A circle.").field("diameter", &CircleShape::diameter, "m").done();
    Record<TubeShape>(m, "TubeShape", "A round tube.")
        .field("outer_diameter", &TubeShape::outer_diameter, "m")
        .field("inner_diameter", &TubeShape::inner_diameter, "m")
        .done();
    Record<IShape>(m, "IShape",
                   "A bar of two flanges and a web, which stands along axis 3 in the middle of the flanges.")
        .field("width", &IShape::width, "width of the flanges, m")
        .field("height", &IShape::height, "m, over all")
        .field("flange_thickness", &IShape::flange_thickness, "m")
        .field("web_thickness", &IShape::web_thickness, "m")
        .done();
}

void bind_sections(py::module_& m) {
    Record<Section>(m, "Section",
                    "The cross-section of a beam. Deformations depend only on areas and moments; the stress "
                    "depends on the shape, too.")
        .field("area", &Section::area, "m^2")
        .field("I2", &Section::I2,
               "second moment for bending about axis 2, m^4: out of the plane, for a beam in a flat pattern")
        .field("I3", &Section::I3, "second moment for bending about axis 3, m^4: in the plane")
        .field("J", &Section::J, "torsion constant, m^4")
        .field("shear_area2", &Section::shear_area2, "shear area along axis 2, m^2; None: shear-rigid")
        .field("shear_area3", &Section::shear_area3, "shear area along axis 3, m^2; None: shear-rigid")
        .field("shape", &Section::shape,
               "shape; None: stresses are those of the rectangle with the same radii of gyration")
        .done();
    m.def("rectangle_section", &rectangle_section, "width"_a, "height"_a,
          "A rectangle of `width` along axis 2 and `height` along axis 3 (m).\n\n"
          ">>> import fretwork\n"
          ">>> fretwork.rectangle_section(2e-3, 2e-3).area\n"
          "4e-06\n");
    m.def("circle_section", &circle_section, "diameter"_a, "m");
    m.def("tube_section", &tube_section, "outer_diameter"_a, "inner_diameter"_a, "m");
    m.def("i_section", &i_section, "shape"_a);
    m.def(
        "section_of", [](const SectionShape& shape) { return section_of(shape); }, "shape"_a,
        "The section of a shape. Raises InputError if a length is not positive, or if lengths contradict "
        "each other.");
    m.def("shape_of", &shape_of, "section"_a,
          "The shape of a section; for a section without a shape, the rectangle with its area and second "
          "moments.");
    m.def("shape_name", &shape_name, "shape"_a, "The name of a shape: 'rectangle', 'circle', 'tube' or 'I'.");
    m.def("section_width", &section_width, "section"_a, "The size of a section along local axis 2, m.");
    m.def("section_height", &section_height, "section"_a, "The size of a section along local axis 3, m.");
    m.def("rectangle_width", &rectangle_width, "section"_a,
          "The width of the rectangle with the section's radii of gyration, m.");
    m.def("rectangle_height", &rectangle_height, "section"_a,
          "The height of the rectangle with the section's radii of gyration, m.");
}

void bind_material(py::module_& m) {
    Record<Material>(m, "Material", "A linear elastic, isotropic material.")
        .field("young_modulus", &Material::young_modulus, "Pa, > 0")
        .field("poisson_ratio", &Material::poisson_ratio, "in (-1, 0.5]")
        .field("density", &Material::density, "kg/m^3, >= 0")
        .field("given_shear_modulus", &Material::given_shear_modulus, "Pa; None: E / (2 (1 + nu))")
        .done()
        .def_property_readonly("shear_modulus", &Material::shear_modulus, "Pa");
}

void bind_frame_parts(py::module_& m) {
    Record<Release>(m, "Release",
                    "A hinge: the components that an end of a beam does not transmit to its node.")
        .field("end", &Release::end, "0 or 1")
        .field("free", &Release::free, "components in the beam's local axes at rest")
        .done();
    Record<Beam>(m, "Beam", "A beam between two nodes.")
        .field("nodes", &Beam::nodes, "two numbers")
        .field("section", &Beam::section, "")
        .field("material", &Beam::material, "")
        .field("normal", &Beam::normal, "local axis 3 at rest; None: global z, or y for a beam along z")
        .field("divisions", &Beam::divisions, "number of elements")
        .field("releases", &Beam::releases, "")
        .done();
    Record<Support>(m, "Support", "Components of a node's total displacement that stay zero.")
        .field("node", &Support::node, "")
        .field("fixed", &Support::fixed, "names of components: 'all', 'ux uy uz', ('ux', 'rz')")
        .done();
    Record<PrescribedDisplacement>(m, "PrescribedDisplacement",
                                   "A component of a displacement with a given value.")
        .field("node", &PrescribedDisplacement::node, "")
        .field("dof", &PrescribedDisplacement::dof, "")
        .field("value", &PrescribedDisplacement::value, "m or rad")
        .done();
    Record<NodalLoad>(m, "NodalLoad", "A force and a moment of fixed direction in space.")
        .field("node", &NodalLoad::node, "")
        .field("force", &NodalLoad::force, "3 floats, N")
        .field("moment", &NodalLoad::moment, "3 floats, N m")
        .done();
}

/// The two nodes of each beam, as one array.
Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> beam_nodes(const Frame& frame) {
    Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> pairs(std::ssize(frame.beams), 2);
    for (Eigen::Index b = 0; b < pairs.rows(); ++b)
        for (Eigen::Index end = 0; end < 2; ++end)
            pairs(b, end) = frame.beams[static_cast<std::size_t>(b)].nodes[static_cast<std::size_t>(end)];
    return pairs;
}

void bind_frame(py::module_& m) {
    Record<Frame>(
        m, "Frame",
        "A structure of beams.\n\n"
        ">>> import fretwork as fw\n"
        ">>> steel = fw.Material(young_modulus=2e11, poisson_ratio=0.3)\n"
        ">>> beam = fw.Beam(nodes=(0, 1), section=fw.rectangle_section(0.01, 0.01), material=steel)\n"
        ">>> frame = fw.Frame(nodes=[[0, 0, 0], [1, 0, 0]], beams=[beam],\n"
        "...                  supports=[fw.Support(0, 'all')], loads=[fw.NodalLoad(1, [0, 0, -1])])\n"
        ">>> tip = fw.solve(frame, solver='linear').displacements[1, 2]\n"
        ">>> print(f'{tip:.6f}')  # -F L^3 / (3 E I)\n"
        "-0.002000\n")
        .field("nodes", &Frame::nodes, "n x 3 floats: rest positions, m")
        .field("beams", &Frame::beams, "")
        .field("supports", &Frame::supports, "")
        .field("prescribed", &Frame::prescribed, "")
        .field("loads", &Frame::loads, "")
        .field("gravity", &Frame::gravity, "3 floats, m/s^2")
        .done()
        .def_property_readonly("beam_nodes", &beam_nodes, "n x 2 ints: the nodes of all beams");
    Record<LabelledFrame>(m, "LabelledFrame", "A frame from a file whose nodes have labels.")
        .field("frame", &LabelledFrame::frame, "")
        .field("labels", &LabelledFrame::labels, "label of each node")
        .field("source", &LabelledFrame::source, "name of the file, for messages")
        .done();
}

void bind_frame_functions(py::module_& m) {
    m.def("validate", py::overload_cast<const Frame&>(&mechanics::validate), "frame"_a,
          "Check that a frame is valid. Raises InputError that names the node or beam.");
    m.def("refined", &refined, "frame"_a, "times"_a,
          "The frame with this many times as many elements in every beam.");
    bind_files<Frame>(m, "frame", {&parse_frame, &frame_text, &read_frame, &write_frame});
    bind_enum<DeckProgram>(m);
    m.def("parse_calculix", &parse_calculix, "text"_a, "source"_a = "text",
          "Read the beams of a CalculiX or Abaqus input deck.");
    m.def("read_calculix", &read_calculix, "path"_a, "Read a deck file.");
    m.def("calculix_text", &calculix_text, "frame"_a, "program"_a = DeckProgram::Abaqus,
          "The text of a deck for a frame.");
    m.def("write_calculix", &write_calculix, "frame"_a, "path"_a);
    m.def("read_structure", &read_structure, "path"_a,
          "Read a structure from a frame file, or from a deck if the file's name ends in .inp.");
    m.attr("STANDARD_GRAVITY") = kStandardGravity;
}

}  // namespace

void bind_frames(py::module_& m) {
    bind_enum<Dof>(m);
    bind_shapes(m);
    bind_sections(m);
    bind_material(m);
    bind_frame_parts(m);
    bind_frame(m);
    bind_frame_functions(m);
}

}  // namespace fretwork::python

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/exports/tables/line_files.hpp>

#include <array>
#include <span>
#include <string_view>

namespace fretwork::exports {
namespace {

using base::format_number;

std::string numbers(const auto& row) {
    std::string text;
    for (Eigen::Index i = 0; i < row.size(); ++i) text += (i > 0 ? " " : "") + format_number(row(i));
    return text;
}

class VtuWriter {
  public:
    explicit VtuWriter(const LineSet& lines) : lines_(lines) {}

    std::string text() && {
        text_ = "<?xml version=\"1.0\"?>\n<!-- " + std::string(base::kMadeBy) +
                " -->\n"
                "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                "<UnstructuredGrid>\n" +
                field_data() + "<Piece NumberOfPoints=\"" + std::to_string(lines_.nodes.size()) +
                "\" NumberOfCells=\"" + std::to_string(lines_.lines.size()) + "\">\n";
        append_points();
        append_cells();
        append_point_data();
        append_cell_data();
        text_ += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
        return std::move(text_);
    }

  private:
    /// Texts that belong to the whole: the ids of the patterns by index, and the joints.
    [[nodiscard]] std::string field_data() const {
        std::string text = texts("pattern_names", lines_.pattern_names);
        if (!lines_.joints.empty()) text += texts("joints", std::array{lines_.joints});
        return text.empty() ? "" : "<FieldData>\n" + text + "</FieldData>\n";
    }

    /// Texts in VTK's form: the codes of their characters, and a 0 at the end of each text.
    [[nodiscard]] static std::string texts(std::string_view name, std::span<const std::string> values) {
        if (values.empty()) return "";
        std::string text = "<DataArray type=\"String\" Name=\"" + std::string(name) + "\" NumberOfTuples=\"" +
                           std::to_string(values.size()) + "\" format=\"ascii\">\n";
        for (const std::string& value : values) {
            for (const char c : value) text += std::to_string(static_cast<int>(c)) + " ";
            text += "0\n";
        }
        return text + "</DataArray>\n";
    }

    void append_points() {
        text_ += "<Points>\n";
        open("Float64", "points", 3);
        for (const Eigen::Vector3d& node : lines_.nodes) text_ += numbers(node) + "\n";
        text_ += "</DataArray>\n</Points>\n";
    }

    void append_cells() {
        constexpr int kVtkLine = 3;
        const std::size_t count = lines_.lines.size();
        text_ += "<Cells>\n";
        open("Int32", "connectivity", 1);
        for (const auto& line : lines_.lines)
            text_ += std::to_string(line[0]) + " " + std::to_string(line[1]) + "\n";
        text_ += "</DataArray>\n";
        open("Int32", "offsets", 1);
        for (std::size_t i = 1; i <= count; ++i) text_ += std::to_string(2 * i) + "\n";
        text_ += "</DataArray>\n";
        open("UInt8", "types", 1);
        for (std::size_t i = 0; i < count; ++i) text_ += std::to_string(kVtkLine) + "\n";
        text_ += "</DataArray>\n</Cells>\n";
    }

    void append_point_data() {
        if (!lines_.displacements && lines_.fields.empty()) return;
        text_ += lines_.displacements ? "<PointData Vectors=\"displacement\">\n" : "<PointData>\n";
        if (lines_.displacements) {
            append_vectors("displacement", lines_.displacements->leftCols<3>());
            append_vectors("rotation", lines_.displacements->rightCols<3>());
        }
        for (const NodeField& field : lines_.fields) append_vectors(field.name, field.vectors);
        text_ += "</PointData>\n";
    }

    void append_vectors(std::string_view name, const Eigen::Ref<const Eigen::MatrixX3d>& vectors) {
        open("Float64", name, 3);
        for (Eigen::Index i = 0; i < vectors.rows(); ++i) text_ += numbers(vectors.row(i)) + "\n";
        text_ += "</DataArray>\n";
    }

    void append_cell_data() {
        if (lines_.tiles.empty()) return;
        text_ += "<CellData Scalars=\"pattern\">\n";
        append_integers("tile", lines_.tiles);
        append_integers("pattern", lines_.patterns);
        for (const LineField& field : lines_.line_fields) {
            open("Float64", field.name, 1);
            for (const double value : field.values) text_ += format_number(value) + "\n";
            text_ += "</DataArray>\n";
        }
        text_ += "</CellData>\n";
    }

    void append_integers(std::string_view name, const std::vector<int>& values) {
        open("Int32", name, 1);
        for (const int value : values) text_ += std::to_string(value) + "\n";
        text_ += "</DataArray>\n";
    }

    void open(std::string_view type, std::string_view name, int components) {
        text_ += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + std::string(name) +
                 "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n";
    }

    const LineSet& lines_;
    std::string text_;
};

}  // namespace

std::string vtu_text(const LineSet& lines) {
    return VtuWriter(lines).text();
}

std::string obj_text(const LineSet& lines) {
    std::string text = "# " + std::string(base::kMadeBy) + ": lengths in metres\n";
    for (const Eigen::Vector3d& node : displaced_nodes(lines)) text += "v " + numbers(node) + "\n";
    for (const auto& line : lines.lines) {
        text += "l " + std::to_string(line[0] + 1) + " " + std::to_string(line[1] + 1) + "\n";
    }
    return text;
}

std::string ply_text(const LineSet& lines) {
    std::string text = "ply\nformat ascii 1.0\ncomment " + std::string(base::kMadeBy) +
                       ": lengths in metres\nelement vertex " + std::to_string(lines.nodes.size()) +
                       "\nproperty double x\nproperty double y\nproperty double z\nelement edge " +
                       std::to_string(lines.lines.size()) +
                       "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
    for (const Eigen::Vector3d& node : displaced_nodes(lines)) text += numbers(node) + "\n";
    for (const auto& line : lines.lines)
        text += std::to_string(line[0]) + " " + std::to_string(line[1]) + "\n";
    return text;
}

std::string csv_text(const LineSet& lines) {
    std::string text = "node,x_m,y_m,z_m,ux_m,uy_m,uz_m,rx_rad,ry_rad,rz_rad\n";
    for (std::size_t i = 0; i < lines.nodes.size(); ++i) {
        text += std::to_string(i);
        for (const double value : lines.nodes[i]) text += "," + format_number(value);
        for (Eigen::Index d = 0; d < mechanics::kDofsPerNode; ++d) {
            const double value = lines.displacements ? (*lines.displacements)(i, d) : 0.0;
            text += "," + format_number(value);
        }
        text += "\n";
    }
    return text;
}

}  // namespace fretwork::exports

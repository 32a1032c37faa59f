// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/meshes/mesh_text.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace fretwork::outlines::detail {
namespace {

/// A type of number, and its size in bytes.
struct Scalar {
    enum class Kind { Signed, Unsigned, Real } kind;
    std::size_t bytes;
};

struct NamedScalar {
    std::string_view name;
    Scalar scalar;
};
using Kind = Scalar::Kind;
constexpr std::array<NamedScalar, 16> kScalars = {{{"char", {Kind::Signed, 1}},
                                                   {"int8", {Kind::Signed, 1}},
                                                   {"uchar", {Kind::Unsigned, 1}},
                                                   {"uint8", {Kind::Unsigned, 1}},
                                                   {"short", {Kind::Signed, 2}},
                                                   {"int16", {Kind::Signed, 2}},
                                                   {"ushort", {Kind::Unsigned, 2}},
                                                   {"uint16", {Kind::Unsigned, 2}},
                                                   {"int", {Kind::Signed, 4}},
                                                   {"int32", {Kind::Signed, 4}},
                                                   {"uint", {Kind::Unsigned, 4}},
                                                   {"uint32", {Kind::Unsigned, 4}},
                                                   {"float", {Kind::Real, 4}},
                                                   {"float32", {Kind::Real, 4}},
                                                   {"double", {Kind::Real, 8}},
                                                   {"float64", {Kind::Real, 8}}}};

struct Property {
    std::string name;
    Scalar type{};
    std::optional<Scalar> count_type{};  ///< type of a list's length; none: not a list
};

/// A table in the file.
struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties;
};

template <class Integer>
double value_of(const char* bytes) {
    Integer value{};
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

/// The value of bytes in the byte order of this machine.
double decode(Scalar type, const char* bytes) {
    if (type.kind == Kind::Real) return type.bytes == 4 ? value_of<float>(bytes) : value_of<double>(bytes);
    const bool has_sign = type.kind == Kind::Signed;
    if (type.bytes == 1) return has_sign ? value_of<std::int8_t>(bytes) : value_of<std::uint8_t>(bytes);
    if (type.bytes == 2) return has_sign ? value_of<std::int16_t>(bytes) : value_of<std::uint16_t>(bytes);
    return has_sign ? value_of<std::int32_t>(bytes) : value_of<std::uint32_t>(bytes);
}

class PlyReader {
  public:
    explicit PlyReader(const std::filesystem::path& path) : text_(path) {}

    MeshFile run() {
        read_header();
        bytes_ = text_.rest();
        for (const Element& element : elements_) {
            for (std::size_t row = 0; row < element.count; ++row) read_row(element, row);
        }
        return std::move(mesh_);
    }

  private:
    enum class Format { Ascii, LittleEndian, BigEndian };

    void read_header() {
        const TextLine first = text_.need_line("the keyword ply");
        if (first.words.front() != "ply") text_.fail(first, "is no PLY file, which begins with ply");
        const TextLine format = text_.need_line("the format");
        if (format.words.size() != 3 || format.words[0] != "format")
            text_.fail(format, "a PLY file says its format here, such as: format ascii 1.0");
        format_ = format_of(format);
        for (TextLine line = need_header_line(); line.words.front() != "end_header";
             line = need_header_line())
            read_header_line(line);
        for (const Element& element : elements_) check(element);
        const auto vertices = std::ranges::find(elements_, "vertex", &Element::name);
        vertex_count_ = vertices == elements_.end() ? 0 : vertices->count;
        if (vertex_count_ == 0) text_.fail("", "has no vertex");
    }
    /// Refuse rows without numbers: the size of the file does not limit how many there are.
    void check(const Element& element) const {
        if (element.count > 0 && element.properties.empty())
            text_.fail("element " + element.name, "has " + std::to_string(element.count) +
                                                      " rows and no property, where at least one is needed");
    }
    TextLine need_header_line() { return text_.need_line("end_header"); }

    [[nodiscard]] Format format_of(const TextLine& line) const {
        if (line.words[1] == "ascii") return Format::Ascii;
        if (line.words[1] == "binary_little_endian") return Format::LittleEndian;
        if (line.words[1] == "binary_big_endian") return Format::BigEndian;
        text_.fail(line, "the format '" + std::string(line.words[1]) +
                             "' is none of ascii, binary_little_endian, binary_big_endian");
    }

    void read_header_line(const TextLine& line) {
        const std::string_view keyword = line.words.front();
        if (keyword == "comment" || keyword == "obj_info") return;
        if (keyword == "element" && line.words.size() == 3) {
            const std::string name(line.words[1]);
            elements_.push_back({name, text_.count(line, line.words[2], "rows of " + name), {}});
        } else if (keyword == "property" && !elements_.empty()) {
            elements_.back().properties.push_back(property_of(line));
        } else {
            text_.fail(line, "'" + std::string(keyword) + "' is not an element, property or comment here");
        }
    }

    [[nodiscard]] Property property_of(const TextLine& line) const {
        if (line.words.size() == 3)
            return {std::string(line.words[2]), scalar_of(line, line.words[1]), std::nullopt};
        if (line.words.size() == 5 && line.words[1] == "list")
            return {std::string(line.words[4]), scalar_of(line, line.words[3]),
                    scalar_of(line, line.words[2])};
        text_.fail(line, "a property is one of: property TYPE NAME, property list TYPE TYPE NAME");
    }
    [[nodiscard]] Scalar scalar_of(const TextLine& line, std::string_view name) const {
        for (const NamedScalar& scalar : kScalars) {
            if (scalar.name == name) return scalar.scalar;
        }
        text_.fail(line, "'" + std::string(name) + "' is not a type of a property");
    }

    void read_row(const Element& element, std::size_t row) {
        place_ = element.name + " " + std::to_string(row);
        if (format_ == Format::Ascii) {
            line_ = text_.need_line(place_ + " of " + std::to_string(element.count) + " (from 0 on)");
            place_ = "line " + std::to_string(line_.number);
            word_ = 0;
        }
        std::array<std::optional<double>, 3> point;
        std::optional<std::vector<long long>> face;
        for (const Property& property : element.properties) {
            const std::vector<double> values = read_property(property);
            if (const auto axis = std::string_view("xyz").find(property.name);
                property.name.size() == 1 && axis != std::string_view::npos && !property.count_type)
                point[axis] = values.front();
            if (property.name == "vertex_indices" || property.name == "vertex_index")
                face = whole_numbers(values);
        }
        if (element.name == "vertex") add_point(point);
        if (element.name == "face") add_face(face);
    }

    [[nodiscard]] std::vector<double> read_property(const Property& property) {
        std::size_t count = 1;
        if (property.count_type) {
            const double promised = scalar(*property.count_type);
            // A count may be NaN, which compares as false.
            if (!(promised >= 0 && promised <= static_cast<double>(text_.size())))
                text_.fail(place_, property.name + " promises " + base::format_number(promised) +
                                       " numbers, and the file has " + std::to_string(text_.size()) +
                                       " bytes");
            count = static_cast<std::size_t>(promised);
        }
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) values.push_back(scalar(property.type));
        return values;
    }

    double scalar(Scalar type) {
        if (format_ == Format::Ascii) {
            if (word_ >= line_.words.size()) text_.fail(line_, "has too few numbers");
            return text_.number(line_, line_.words[word_++]);
        }
        if (bytes_.size() < type.bytes) text_.fail(place_, "the file ends here");
        std::array<char, 8> bytes{};
        std::copy_n(bytes_.begin(), type.bytes, bytes.begin());
        bytes_.remove_prefix(type.bytes);
        const bool is_native =
            (format_ == Format::LittleEndian) == (std::endian::native == std::endian::little);
        if (!is_native) std::reverse(bytes.begin(), bytes.begin() + type.bytes);
        return decode(type, bytes.data());
    }

    [[nodiscard]] std::vector<long long> whole_numbers(const std::vector<double>& values) const {
        std::vector<long long> numbers;
        for (const double value : values) {
            if (value != std::floor(value) || std::abs(value) > 1e15)
                text_.fail(place_, base::format_number(value) + " is not a vertex");
            numbers.push_back(static_cast<long long>(value));
        }
        return numbers;
    }

    void add_point(const std::array<std::optional<double>, 3>& point) {
        mesh_.points.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            if (!point[i]) text_.fail(place_, std::string("the vertex has no ") + "xyz"[i]);
            if (!std::isfinite(*point[i]))
                text_.fail(place_, std::string("xyz").substr(i, 1) + " is not finite");
            mesh_.points.back()[i] = *point[i];
        }
    }
    void add_face(const std::optional<std::vector<long long>>& vertices) {
        if (!vertices) text_.fail(place_, "the face has no list vertex_indices");
        text_.add_face(place_, *vertices, vertex_count_, mesh_);
    }

    MeshText text_;
    Format format_ = Format::Ascii;
    std::vector<Element> elements_;
    std::size_t vertex_count_ = 0;
    MeshFile mesh_;
    std::string place_;       // place of the row in messages
    TextLine line_;           // line of the row, in an ASCII file
    std::size_t word_ = 0;    // index of the next word in the line
    std::string_view bytes_;  // bytes that are not read yet, in a binary file
};

}  // namespace

MeshFile read_ply(const std::filesystem::path& path) {
    return PlyReader(path).run();
}

}  // namespace fretwork::outlines::detail

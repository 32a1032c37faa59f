// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/frame/detail/frame_check.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/internal/node_json.hpp>
#include <fretwork/mechanics/internal/section_json.hpp>

#include <algorithm>
#include <map>

namespace fretwork::mechanics {
namespace {

using base::Json;
using base::JsonReader;

Eigen::Vector3d read_vector(const JsonReader& reader) {
    const std::vector<double> v = reader.numbers(3);
    return {v[0], v[1], v[2]};
}

Eigen::Vector3d read_optional_vector(const JsonReader& owner, std::string_view key) {
    const auto member = owner.find(key);
    return member ? read_vector(*member) : Eigen::Vector3d::Zero();
}

/// Refuse a number of a section or a material that is out of its limits, where it stands in the file.
template <class Value>
Value within_limits(const JsonReader& reader, const Value& value) {
    const auto flaw = detail::flaw_of(value);
    if (!flaw) return value;
    if (const auto number = reader.find(flaw->key)) number->fail(flaw->problem);
    reader.fail("has no valid " + std::string(flaw->key) + ": it " + flaw->problem);
}

Section read_limited_section(const JsonReader& reader) {
    return within_limits(reader, read_section(reader));
}

Material read_material(const JsonReader& reader) {
    reader.allow_only({"young_modulus", "poisson_ratio", "density", "shear_modulus"});
    Material material;
    material.young_modulus = reader.at("young_modulus").positive_number();
    if (const auto given = reader.find("shear_modulus"))
        material.given_shear_modulus = given->positive_number();
    if (!material.given_shear_modulus || reader.find("poisson_ratio"))
        material.poisson_ratio = reader.at("poisson_ratio").number();
    if (const auto density = reader.find("density")) material.density = density->number();
    return within_limits(reader, material);
}

template <class Value>
std::map<std::string, Value> read_table(const JsonReader& reader, Value (*read)(const JsonReader&)) {
    std::map<std::string, Value> table;
    for (const auto& [name, member] : reader.members()) table.emplace(name, read(member));
    return table;
}

template <class Value>
const Value& look_up(const std::map<std::string, Value>& table, const JsonReader& name, const char* kind) {
    const auto found = table.find(name.string());
    if (found != table.end()) return found->second;
    std::vector<std::string> known;
    known.reserve(table.size());
    for (const auto& entry : table) known.push_back(entry.first);
    name.fail(base::unknown_name_message(kind, name.string(), known));
}

class FrameReader {
  public:
    explicit FrameReader(const JsonReader& document) : document_(document) {}

    /// The checked frame. Messages name `source`.
    Frame read(const std::string& source) && {
        read_lists();
        detail::check_frame(frame_, {.source = source, .prescribed_entries = prescribed_entries_});
        return std::move(frame_);
    }

  private:
    void read_lists() {
        document_.expect_format("frame", 2);
        document_.allow_only({"format", "nodes", "materials", "sections", "beams", "supports", "prescribed",
                              "loads", "gravity"});
        for (const JsonReader& node : document_.at("nodes").elements())
            frame_.nodes.push_back(read_vector(node));
        materials_ = read_table(document_.at("materials"), read_material);
        sections_ = read_table(document_.at("sections"), read_limited_section);
        for (const JsonReader& beam : document_.at("beams").elements())
            frame_.beams.push_back(read_beam(beam));
        for (const JsonReader& support : optional_list("supports")) read_support(support);
        const auto prescribed = optional_list("prescribed");
        for (std::size_t entry = 0; entry < prescribed.size(); ++entry)
            read_prescribed(prescribed[entry], entry);
        for (const JsonReader& load : optional_list("loads")) read_load(load);
        frame_.gravity = read_optional_vector(document_, "gravity");
    }

    [[nodiscard]] std::vector<JsonReader> optional_list(std::string_view key) const {
        const auto member = document_.find(key);
        return member ? member->elements() : std::vector<JsonReader>{};
    }

    [[nodiscard]] NodeIndex read_node(const JsonReader& reader) const {
        if (frame_.nodes.empty()) reader.fail("is " + reader.text() + ", but the frame has no nodes");
        return NodeIndex(reader.integer(0, static_cast<long long>(frame_.nodes.size()) - 1));
    }

    [[nodiscard]] Beam read_beam(const JsonReader& reader) const {
        reader.allow_only({"nodes", "section", "material", "normal", "divisions", "releases"});
        const auto ends = reader.at("nodes").elements(2);
        Beam beam{.nodes = {read_node(ends[0]), read_node(ends[1])},
                  .section = look_up(sections_, reader.at("section"), "section"),
                  .material = look_up(materials_, reader.at("material"), "material")};
        if (const auto normal = reader.find("normal")) beam.normal = read_vector(*normal);
        if (const auto count = reader.find("divisions"))
            beam.divisions = static_cast<int>(count->integer(1, kMostDivisions));
        if (const auto releases = reader.find("releases")) {
            for (const JsonReader& release : releases->elements()) {
                release.allow_only({"end", "free"});
                beam.releases.push_back(
                    {static_cast<int>(release.at("end").integer(0, 1)), read_dofs(release.at("free"))});
            }
        }
        return beam;
    }

    void read_support(const JsonReader& reader) {
        reader.allow_only({"node", "fixed"});
        frame_.supports.push_back({read_node(reader.at("node")), read_dofs(reader.at("fixed"))});
    }

    void read_prescribed(const JsonReader& reader, std::size_t entry) {
        reader.allow_only({"node", "ux", "uy", "uz", "rx", "ry", "rz"});
        const NodeIndex node = read_node(reader.at("node"));
        for (std::size_t d = 0; d < kDofsPerNode; ++d) {
            const auto value = reader.find(kDofNames[d]);
            if (!value) continue;
            frame_.prescribed.push_back({node, static_cast<Dof>(d), value->number()});
            prescribed_entries_.push_back(entry);
        }
    }

    void read_load(const JsonReader& reader) {
        reader.allow_only({"node", "force", "moment"});
        frame_.loads.push_back({read_node(reader.at("node")), read_optional_vector(reader, "force"),
                                read_optional_vector(reader, "moment")});
    }

    const JsonReader& document_;
    Frame frame_;
    std::vector<std::size_t> prescribed_entries_;  ///< entry of each prescribed component
    std::map<std::string, Material> materials_;
    std::map<std::string, Section> sections_;
};

Json material_json(const Material& material) {
    Json json = {{"young_modulus", material.young_modulus}, {"poisson_ratio", material.poisson_ratio}};
    if (material.density > 0) json["density"] = material.density;
    if (material.given_shear_modulus) json["shear_modulus"] = *material.given_shear_modulus;
    return json;
}

/// The different values of a list, in order of appearance, with the names that the file gives them.
template <class Value>
class NameTable {
  public:
    explicit NameTable(std::string stem) : stem_(std::move(stem)) {}
    std::string name_of(const Value& value) {
        const auto found = std::find(values_.begin(), values_.end(), value);
        const auto index = found - values_.begin();
        if (found == values_.end()) values_.push_back(value);
        return stem_ + std::to_string(index);
    }
    [[nodiscard]] Json json(Json (*write)(const Value&)) const {
        Json table = Json::object();
        for (std::size_t i = 0; i < values_.size(); ++i) table[stem_ + std::to_string(i)] = write(values_[i]);
        return table;
    }

  private:
    std::string stem_;
    std::vector<Value> values_;
};

Json beam_json(const Beam& beam, const std::string& section, const std::string& material) {
    Json json = {
        {"nodes", {beam.nodes[0].value, beam.nodes[1].value}}, {"section", section}, {"material", material}};
    if (beam.normal) json["normal"] = vector_json(*beam.normal);
    if (beam.divisions != 1) json["divisions"] = beam.divisions;
    for (const Release& release : beam.releases)
        json["releases"].push_back({{"end", release.end}, {"free", dofs_json(release.free)}});
    return json;
}

void append_beams(Json& document, const Frame& frame) {
    NameTable<Material> materials("material");
    NameTable<Section> sections("section");
    Json beams = Json::array();
    for (const Beam& beam : frame.beams)
        beams.push_back(beam_json(beam, sections.name_of(beam.section), materials.name_of(beam.material)));
    document["materials"] = materials.json(material_json);
    document["sections"] = sections.json(section_json);
    document["beams"] = std::move(beams);
}

void append_conditions(Json& document, const Frame& frame) {
    for (const Support& support : frame.supports)
        document["supports"].push_back({{"node", support.node.value}, {"fixed", dofs_json(support.fixed)}});
    for (const PrescribedDisplacement& given : frame.prescribed)
        document["prescribed"].push_back({{"node", given.node.value}, {dof_name(given.dof), given.value}});
    for (const NodalLoad& load : frame.loads)
        document["loads"].push_back({{"node", load.node.value},
                                     {"force", vector_json(load.force)},
                                     {"moment", vector_json(load.moment)}});
    if (!frame.gravity.isZero(0.0)) document["gravity"] = vector_json(frame.gravity);
}

}  // namespace

Frame parse_frame(std::string_view text, const std::string& source) {
    return FrameReader(JsonReader::from_text(text, source)).read(source);
}

Frame read_frame(const std::filesystem::path& path) {
    return parse_frame(base::read_text_file(path), path.string());
}

std::string frame_text(const Frame& frame) {
    const bool is_newer =
        std::ranges::any_of(frame.beams, [](const Beam& beam) { return is_of_newer_format(beam.section); });
    Json document = {{"format", is_newer ? "fretwork/frame/2" : "fretwork/frame/1"}};
    const double* const places = frame.nodes.empty() ? nullptr : frame.nodes.front().data();
    document["nodes"] = base::number_rows({places, 3 * frame.nodes.size()}, 3);
    append_beams(document, frame);
    append_conditions(document, frame);
    return base::json_text(document);
}

void write_frame(const Frame& frame, const std::filesystem::path& path) {
    base::write_file_atomically(path, frame_text(frame));
}

}  // namespace fretwork::mechanics

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/text.hpp>
#include <studio/server/binary_messages.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

namespace fretwork::studio {
namespace {

static_assert(std::endian::native == std::endian::little, "messages are written as they lie in memory");

constexpr std::uint32_t kMagic = 0x46575254;  // "FWRT"

constexpr std::size_t kHeaderBytes = 8 * sizeof(std::uint32_t);

using Rows = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

class Writer {
  public:
    Writer(MessageKind kind, const FrameStamp& stamp, const std::array<std::size_t, 4>& counts) {
        add(kMagic);
        add(static_cast<std::uint32_t>(kind));
        add(static_cast<std::uint32_t>(stamp.revision));
        for (const std::size_t count : counts) add(static_cast<std::uint32_t>(count));
        add(static_cast<std::uint32_t>(stamp.beams));
    }
    void add(std::uint32_t value) { add_bytes(&value, sizeof value); }
    void add(double value) {
        const auto single = static_cast<float>(value);
        add_bytes(&single, sizeof single);
    }
    /// In the order in which the matrix lies in memory.
    template <class Matrix>
    void add(const Eigen::PlainObjectBase<Matrix>& values) {
        add_bytes(values.data(), sizeof(float) * values.size());
    }
    void reserve(std::size_t values) { bytes_.reserve(bytes_.size() + sizeof(float) * values); }
    std::string take() { return std::move(bytes_); }

  private:
    void add_bytes(const void* from, std::size_t count) {
        if (count > 0) bytes_.append(static_cast<const char*>(from), count);
    }
    std::string bytes_;
};

}  // namespace

std::string beams_message(const simulation::SurfaceBeams& beams, const FrameStamp& stamp) {
    Writer writer(MessageKind::Beams, stamp, {beams.nodes.size(), beams.ends.size(), 0, 0});
    writer.reserve(3 * beams.nodes.size() + 6 * beams.ends.size());
    for (const Eigen::Vector3d& node : beams.nodes) {
        for (const double coordinate : node) writer.add(coordinate);
    }
    for (const auto& [a, b] : beams.ends) {
        writer.add(static_cast<std::uint32_t>(a.value));
        writer.add(static_cast<std::uint32_t>(b.value));
    }
    for (const tiling::TileIndex tile : beams.tiles) writer.add(static_cast<std::uint32_t>(tile.value));
    for (std::size_t b = 0; b < beams.ends.size(); ++b) {
        for (const double component : Eigen::Vector3d(Eigen::Vector3d::UnitZ())) writer.add(component);
    }
    return writer.take();
}

std::vector<std::string> names_of(const BeamFields& fields) {
    std::vector<std::string> names;
    for (std::size_t f = 0; f < fields.size(); ++f) {
        if (fields[f]) names.emplace_back(simulation::kBeamFields[f]);
    }
    return names;
}

BeamFields read_beam_fields(const base::JsonReader& json) {
    const std::vector<std::string> known(simulation::kBeamFields.begin(), simulation::kBeamFields.end());
    BeamFields fields;
    for (const base::JsonReader& element : json.elements()) {
        const std::string name = element.string();
        const auto place = std::ranges::find(known, name);
        if (place == known.end()) element.fail(base::unknown_name_message("field", name, known));
        fields.set(place - known.begin());
    }
    return fields;
}

std::string solution_message(const simulation::BeamState& state, const FrameStamp& stamp,
                             const BeamFields& fields) {
    const std::size_t nodes = state.nodes.rows();
    const std::size_t ends = fields.any() ? state.forces.rows() : 0;
    const std::size_t count = ends > 0 ? fields.count() : 0;
    Writer writer(MessageKind::Solution, stamp, {nodes, ends / 2, 0, count});
    writer.reserve(6 * nodes + count * ends);
    writer.add(Rows(state.nodes.leftCols<3>().cast<float>()));
    writer.add(Rows(state.nodes.rightCols<3>().cast<float>()));
    for (std::size_t f = 0; f < fields.size() && count > 0; ++f) {
        if (fields[f]) writer.add(Eigen::VectorXf(state.forces.col(f).cast<float>()));
    }
    return writer.take();
}

std::size_t solution_bytes(const simulation::SurfaceBeams& beams, const BeamFields& fields) {
    const std::size_t values = 6 * beams.nodes.size() + 2 * fields.count() * beams.ends.size();
    return kHeaderBytes + sizeof(float) * values;
}

std::string motion_message(const mechanics::NodeValues& nodes, const FrameStamp& stamp,
                           const Eigen::MatrixXf& node_fields) {
    const std::size_t count = nodes.rows();
    Writer writer(MessageKind::Solution, stamp, {count, 0, static_cast<std::size_t>(node_fields.cols()), 0});
    writer.reserve((6 + node_fields.cols()) * count);
    writer.add(Rows(nodes.leftCols<3>().cast<float>()));
    writer.add(Rows(nodes.rightCols<3>().cast<float>()));
    writer.add(node_fields);
    return writer.take();
}

}  // namespace fretwork::studio

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/json_reader.hpp>
#include <fretwork/simulation/results/surface_beams.hpp>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fretwork::studio {

/// Binary messages of the protocol (protocol.md).
enum class MessageKind : std::uint32_t { Beams = 1, Solution = 2 };

/// The revision of the document, and the revision for which the beams of the message were sent (`beams`).
struct FrameStamp {
    std::int64_t revision = 0;
    std::int64_t beams = 0;
};

std::string beams_message(const simulation::SurfaceBeams& beams, const FrameStamp& stamp);

/// The wanted ones of simulation::kBeamFields.
using BeamFields = std::bitset<simulation::kBeamFields.size()>;
inline const BeamFields kAllBeamFields = BeamFields().set();
std::vector<std::string> names_of(const BeamFields& fields);
/// Read a list of names of fields. Throws InputError for an unknown name.
BeamFields read_beam_fields(const base::JsonReader& json);

/// The message has all wanted fields, or none if the state has no forces.
std::string solution_message(const simulation::BeamState& state, const FrameStamp& stamp,
                             const BeamFields& fields);
/// The number of bytes of a solution_message() with all wanted fields.
std::size_t solution_bytes(const simulation::SurfaceBeams& beams, const BeamFields& fields);
/// The message has no beam fields.
///
/// @param node_fields  a row for each node, a column for each field
std::string motion_message(const mechanics::NodeValues& nodes, const FrameStamp& stamp,
                           const Eigen::MatrixXf& node_fields = {});

}  // namespace fretwork::studio

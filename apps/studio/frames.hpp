// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/simulation/surface_beams.hpp>

#include <cstdint>
#include <string>

namespace fretwork::studio {

/// Binary messages of the protocol (protocol.md).
enum class MessageKind : std::uint32_t { Beams = 1, Solution = 2 };

/// Which beams a message is about: the revision of the document for which they were sent.
struct FrameStamp {
    std::int64_t revision = 0;
    std::int64_t beams = 0;
};

std::string beams_message(const simulation::SurfaceBeams& beams, const FrameStamp& stamp);

/// With the beam fields simulation::kBeamFields, if the state has any.
///
/// @param node_fields  further fields: a row for each node, a column each
std::string solution_message(const simulation::BeamState& state, const FrameStamp& stamp,
                             const Eigen::MatrixXf& node_fields = {});

}  // namespace fretwork::studio

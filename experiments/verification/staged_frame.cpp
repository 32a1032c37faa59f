// SPDX-License-Identifier: GPL-3.0-or-later
// A frame in three stages, as bending-active structures are erected: its loads lift it while it is held where
// its displacements are prescribed; the prescribed displacements follow; the loads go. One line for each
// stage (CSV) on standard output, and the displacements at the end in a table. Usage:
// verification_staged_frame FRAME.json DISPLACEMENTS.csv
#include <fretwork/base/error.hpp>
#include <fretwork/base/files/file.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/mechanics/assembly.hpp>
#include <fretwork/mechanics/frame/frame_file.hpp>
#include <fretwork/mechanics/paths/staged_path.hpp>

#include <cstdio>

namespace fretwork::verification {
namespace {

using mechanics::NodeValues;
using mechanics::Solution;
using mechanics::StageTarget;

std::string displacements_csv(const NodeValues& rows) {
    std::string text = "ux,uy,uz,rx,ry,rz\n";
    for (Eigen::Index node = 0; node < rows.rows(); ++node) {
        for (int k = 0; k < mechanics::kDofsPerNode; ++k)
            text += (k == 0 ? "" : ",") + base::format_number(rows(node, k));
        text += "\n";
    }
    return text;
}

void print(const char* stage, const Solution& solution) {
    std::printf("%s,%d,%g,%d,%g,%d,%zu\n", stage, solution.converged() ? 1 : 0, solution.load_factor,
                solution.stable ? 1 : 0, solution.energy, solution.iterations,
                solution.stability_losses.size());
}

/// True if the structure got where it was to go.
bool run(const std::string& frame_file, const std::string& out) {
    const mechanics::Frame frame = mechanics::read_frame(frame_file);
    const mechanics::Assembly assembly = mechanics::assemble(frame);
    const NodeValues none = NodeValues::Zero(assembly.loads.rows(), assembly.loads.cols());
    std::vector<mechanics::PrescribedDisplacement> held = frame.prescribed;
    for (mechanics::PrescribedDisplacement& component : held) component.value = 0.0;
    const std::pair<const char*, StageTarget> stages[] = {
        {"lift", {frame.supports, held, assembly.loads}},
        {"move", {frame.supports, frame.prescribed, assembly.loads}},
        {"release", {frame.supports, frame.prescribed, none}}};
    mechanics::StagedPath path(assembly, {.branch = mechanics::Branch::Snapping});
    std::printf("stage,converged,reached,stable,energy_J,iterations,stability_losses\n");
    Solution solution;
    for (const auto& [name, target] : stages) {
        solution = path.advance(target);
        print(name, solution);
        if (!solution.converged()) break;
    }
    base::write_file_atomically(out, displacements_csv(solution.displacements));
    return solution.converged();
}

}  // namespace
}  // namespace fretwork::verification

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: verification_staged_frame FRAME.json DISPLACEMENTS.csv\n");
        return 2;
    }
    try {
        return fretwork::verification::run(argv[1], argv[2]) ? 0 : 1;
    } catch (const fretwork::base::Error& error) {
        std::fprintf(stderr, "verification_staged_frame: %s\n", error.what());
        return 2;
    }
}

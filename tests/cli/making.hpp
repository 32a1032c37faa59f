// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the tests of cutting and printing.
#pragma once

#include "cli/making_files.hpp"
#include "cli/refusal.hpp"

#include <nlohmann/json.hpp>

namespace fretwork::test {

/// A specimen that is held at two places, and its exports.
class Making : public testing::Test {
  protected:
    Making() {
        (void)folder_.file("held.json", R"({"format": "fretwork/load-case/1", "name": "held",
            "supports": [{"nearest": [[0, 0.13], [0.18, 0.13]],
                          "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}]})");
        succeed(
            "fretwork tile experiments/outlines/specimen.svg --edge-length 40mm --patterns 1-3+3-6 --out "
            "p.json && fretwork case add p.json held.json");
    }
    std::string succeed(const std::string& command) const {
        const Outcome outcome = run_command(command, folder_.path());
        EXPECT_EQ(outcome.exit_code, 0) << command << "\n" << outcome.err;
        return outcome.out;
    }
    std::string exported(const std::string& file, const std::string& options = "") const {
        succeed("fretwork export p.json --to " + file + " " + options);
        return base::read_text_file(folder_.path() / file);
    }
    std::vector<Contour> cut(const std::string& options = "") const {
        return polylines(exported("cut.dxf", options), "cut");
    }
    nlohmann::json facts(const std::string& options = "") const {
        return nlohmann::json::parse(exported("facts.json", "--content facts " + options));
    }
    void refuse(const std::string& options, const std::string& complaint) const {
        expect_refused("fretwork export p.json " + options, folder_.path(), complaint);
    }
    TemporaryFolder folder_;
};

}  // namespace fretwork::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Files that the system does not let grow: a limit of the shell (ulimit -f), names that no file can have.
#include "cli/command.hpp"
#include "cli/refusal.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::expect_refused;
using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

class FileLimit : public testing::Test {
  protected:
    FileLimit() {
        const auto made = run_command(
            "fretwork tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 --out "
            "p.json && "
            "fretwork case add p.json experiments/cases/cantilever.json && "
            "fretwork simulate p.json --case cantilever --model full --out r.json --frame-out f.json",
            folder_.path());
        EXPECT_EQ(made.exit_code, 0) << made.err;
    }
    TemporaryFolder folder_;
};

TEST_F(FileLimit, IsToldLikeAFullDiskAndLeavesNothing) {
    for (const std::string command :
         {"simulate p.json --case cantilever --model full --out new.json", "solve f.json --out new.json",
          "export p.json --to new.svg", "export p.json --to new.dxf --content cut",
          "draw 0-1+1-6 --out new.svg", "enumerate --edges 4 --list new.txt",
          "enumerate --edges 2 --library new.db", "beams p.json r.json --out new.csv",
          "case add p.json experiments/cases/own_weight.json",
          "paint p.json --tiles all --patterns 0-1+1-2 --out new.json"}) {
        const std::string before = base::read_text_file(folder_.path() / "p.json");
        expect_refused("(ulimit -f 1; exec fretwork " + command + ")", folder_.path(), "");
        EXPECT_EQ(base::read_text_file(folder_.path() / "p.json"), before) << command;
    }
    expect_refused("(ulimit -f 1; exec fretwork solve f.json --out new.json)", folder_.path(),
                   "new.json: cannot be written: File too large");
}

TEST_F(FileLimit, OfNamesIsToldInOneLine) {
    const std::string name(300, 'A');
    for (const std::string& command :
         {"fretwork enumerate --edges 2 --layout " + name, "fretwork export p.json --to " + name + ".svg",
          "fretwork solve " + name + " --out new.json", "fretwork solve f.json --out " + name + ".json",
          "fretwork tile " + name + " --out new.json",
          "fretwork simulate p.json --case " + name + " --out new.json",
          "fretwork tile experiments/outlines/specimen.svg --patterns " + name + " --out new.json",
          "fretwork studio --page " + name, "fretwork studio " + name}) {
        expect_refused(command, folder_.path(), "");
        EXPECT_THAT(run_command(command, folder_.path()).err, testing::Not(HasSubstr("filesystem error")))
            << command;
    }
}

TEST_F(FileLimit, ASeriesIsNoDevice) {
    expect_refused(
        "fretwork simulate p.json --case cantilever --model full --out new.json --series /dev/full",
        folder_.path(), "/dev/full: is a device, which takes one file");
}

TEST_F(FileLimit, AFullDeviceIsToldAlikeByEachCommand) {
    const std::string tile =
        "tile experiments/outlines/specimen.svg --edge-length 60mm --patterns 0-1+1-6 --out ";
    for (const std::string& command :
         {tile, std::string("solve f.json --out "), std::string("paint p.json --patterns 0-1+1-6 --out "),
          std::string("retile p.json --edge-length 50mm --out ")})
        expect_refused("fretwork " + command + "/dev/full", folder_.path(),
                       "/dev/full: cannot be written: No space left on device");
    const auto piped = run_command("fretwork " + tile + "/dev/stdout | cat", folder_.path());
    EXPECT_THAT(piped.out, HasSubstr("fretwork/project/")) << piped.err;
}

// The verb adds what the thrower does not know: whose load cases, whose beams.
TEST_F(FileLimit, MessagesNameTheFile) {
    ASSERT_EQ(
        run_command("fretwork case add p.json experiments/cases/own_weight.json", folder_.path()).exit_code,
        0);
    expect_refused("fretwork simulate p.json --model full --out new.json", folder_.path(),
                   "p.json: the project has several load cases; choose one: cantilever, ");
    folder_.file("divided.json", R"({"format": "fretwork/frame/1", "nodes": [[0, 0, 0], [0, 0, 1]],
        "materials": {"m": {"young_modulus": 1e9, "poisson_ratio": 0.3}},
        "sections": {"s": {"type": "rectangle", "width": 0.01, "height": 0.02}},
        "beams": [{"nodes": [0, 1], "section": "s", "material": "m", "divisions": 8}],
        "supports": [{"node": 0, "fixed": ["ux", "uy", "uz", "rx", "ry", "rz"]}]})");
    expect_refused("fretwork solve divided.json --out new.json --deck new.inp", folder_.path(),
                   "divided.json: /beams/0 has divisions");
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

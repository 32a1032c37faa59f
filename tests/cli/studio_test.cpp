// SPDX-License-Identifier: GPL-3.0-or-later
// What the studio refuses before it listens.
#include "cli/command.hpp"
#include "cli/refusal.hpp"
#include "support.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::expect_refused;
using test::TemporaryFolder;

TEST(StudioVerb, RefusesLayoutsThatCannotBeDrawn) {
    const TemporaryFolder folder;
    folder.file("frame.json", R"({"format": "fretwork/frame/1", "nodes": []})");
    folder.file("wrong.json", R"({"format": "fretwork/layout/1", "name": "wrong", "interface": ["1/3"]})");
    expect_refused("fretwork studio --no-browser --layout papr7", folder.path(), "'paper7'");
    expect_refused("fretwork studio --no-browser --layout ''", folder.path(), "--layout '' is empty");
    expect_refused("fretwork studio --no-browser --layout none.json", folder.path(), "none.json");
    expect_refused("fretwork studio --no-browser --layout frame.json", folder.path(), "frame.json: /format");
    expect_refused("fretwork studio --no-browser --layout wrong.json", folder.path(),
                   "wrong.json: /interface/0: node n1 at 1/3 has no twin");
    expect_refused("fretwork studio --no-browser --layout " + std::string(300, 'A'), folder.path(), "AAA");
}

TEST(StudioVerb, DrawsALayoutOrShowsAProject) {
    const TemporaryFolder folder;
    folder.file("p.json", "{}");
    expect_refused("fretwork studio --no-browser p.json --layout", folder.path(), "give one of them");
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

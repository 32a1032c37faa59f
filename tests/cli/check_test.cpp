// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/refusal.hpp"
#include "support.hpp"

#include <algorithm>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace fretwork::app {
namespace THIS_TEST {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

/// A file of a kind: its name, its text, and its kind as the program prints it.
struct Sample {
    std::string name;
    std::string text;
    std::string kind;
};

const std::vector<Sample>& samples() {
    static const std::vector<Sample> kSamples = {
        {"layout.json", R"({"format":"fretwork/layout/1","name":"one","center":true,"interface":["1/2"]})",
         "fretwork/layout/1"},
        {"frame.json",
         R"({"format":"fretwork/frame/1","nodes":[[0,0,0],[1,0,0]],
            "materials":{"m":{"young_modulus":1e9,"poisson_ratio":0.3}},
            "sections":{"s":{"type":"rectangle","width":0.1,"height":0.1}},
            "beams":[{"nodes":[0,1],"section":"s","material":"m"}],
            "supports":[{"node":0,"fixed":["ux","uy","uz","rx","ry","rz"]}]})",
         "fretwork/frame/1"},
        {"scenario.json",
         R"({"format":"fretwork/scenario/1","name":"pull","weight":1,"max_magnitude":2,
            "held":[{"interface_node":0,"fixed":["ux","uy","uz","rx","ry","rz"]}],
            "loads":[{"interface_node":3,"force":[0,1,0]}]})",
         "fretwork/scenario/1"},
        {"setting.json", R"({"format":"fretwork/setting/2","tile_side":0.02})", "fretwork/setting/2"},
        {"case.json", R"({"format":"fretwork/load-case/1","name":"hang","gravity":[0,0,-9.81]})",
         "fretwork/load-case/1"},
        {"circle.json",
         R"({"format":"fretwork/load-case/4","name":"push",
            "loads":[{"circle":{"center":[0.1,0.1],"radius":0.05},"force":[0,0,-1]}]})",
         "fretwork/load-case/4"},
        {"painting.json", R"({"format":"fretwork/painting/1","layout":"paper7","patterns":["0-1+1-6"]})",
         "fretwork/painting/1"},
        {"stages.json",
         R"({"format":"fretwork/stages/1","stages":[{"name":"a","loads":[{"load_case":"hang","factor":1}]}]})",
         "fretwork/stages/1"},
        {"target.json",
         R"({"format":"fretwork/target/1","goals":[{"nodes":[0],"displacements":[[null,null,0.01]]}]})",
         "fretwork/target/1"},
        {"outline.json", R"({"format":"fretwork/outline/1","boundary":[[0,0],[0.4,0],[0,0.3]]})",
         "fretwork/outline/1"},
        {"beams.json",
         R"({"format":"fretwork/beams/2","joints":"stiff","strength":null,"utilization_formula":"none",
            "unknown_beams":0,"beams":[]})",
         "fretwork/beams/2"},
        {"facts.json",
         R"({"format":"fretwork/facts/2","joints":"stiff","tiles":1,"bars":6,"pieces":1,"openings":0,
            "size":[0.1,0.1,0.002],"area":0.001,"volume":2e-6,"mass":0,"beam_mass":0,"cut_length":0.5,
            "contours":1,"layers":10,"wall_length":5,"sharpest_angle":1,"smallest_inner_radius":0,
            "warnings":[]})",
         "fretwork/facts/2"},
        {"json_of_another_ending.txt", R"({"format":"fretwork/setting/2","tile_side":0.02})",
         "fretwork/setting/2"},
        {"json_with_a_byte_order_mark.txt",
         "\xef\xbb\xbf\n"
         R"({"format":"fretwork/setting/2","tile_side":0.02})",
         "fretwork/setting/2"},
        {"outline.svg",
         R"(<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200"><path d="M0 0H200V200H0Z"/></svg>)",
         "outline (svg)"},
        {"outline.dxf", "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n10\n0\n20\n0\n40\n0.2\n0\nENDSEC\n0\nEOF\n",
         "outline (dxf)"},
        {"mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.2\nf 1 2 3\n", "mesh (obj)"},
        {"mesh.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "mesh (off)"},
        {"mesh.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
         "mesh (ply)"}};
    return kSamples;
}

/// The text of the sample with a name.
const std::string& text_of(const std::string& name) {
    return std::ranges::find(samples(), name, &Sample::name)->text;
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

TEST(Check, NamesTheKindOfEveryValidFile) {
    const TemporaryFolder folder;
    for (const Sample& sample : samples()) {
        write(folder.path() / sample.name, sample.text);
        const auto outcome = run_command("fretwork check " + sample.name, folder.path());
        EXPECT_EQ(outcome.out, sample.name + ": valid " + sample.kind + "\n") << outcome.err;
        EXPECT_EQ(outcome.exit_code, 0) << sample.name;
    }
}

TEST(Check, RefusesEveryKindCutShortInOneLine) {
    const TemporaryFolder folder;
    for (const Sample& sample : samples()) {
        write(folder.path() / sample.name, sample.text.substr(0, sample.text.size() / 3));
        const auto outcome = run_command("fretwork check " + sample.name, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << sample.name;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(sample.name));
    }
}

TEST(Check, RefusesAnUnknownKeyInEveryKindOfJson) {
    const TemporaryFolder folder;
    for (const Sample& sample : samples()) {
        if (!sample.name.ends_with(".json")) continue;
        write(folder.path() / sample.name, "{\"surprise\":1," + sample.text.substr(1));
        const auto outcome = run_command("fretwork check " + sample.name, folder.path());
        EXPECT_EQ(outcome.exit_code, 2) << sample.name;
        EXPECT_THAT(outcome.err, HasSubstr("surprise"));
    }
}

TEST(Check, TakesTheFilesThatTheProgramWrites) {
    const TemporaryFolder folder;
    write(folder.path() / "frame.json", text_of("frame.json"));
    write(folder.path() / "square.json", text_of("outline.json"));
    const auto made = run_command(
        "fretwork solve frame.json --out frame_result.json && "
        "fretwork tile square.json --patterns 0-1+1-6 --edge-length 40mm --out project.json && "
        "fretwork simulate project.json --case experiments/cases/cantilever.json --model full --linear "
        "--out result.json && "
        "fretwork enumerate --layout faces5 --library made.db",
        folder.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const auto outcome =
        run_command("fretwork check frame_result.json project.json result.json made.db", folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::MatchesRegex("frame_result.json: valid fretwork/result/[45]\n"
                                                   "project.json: valid fretwork/project/2\n"
                                                   "result.json: valid fretwork/result/[45]\n"
                                                   "made.db: valid library\n"));
    const auto broken = run_command(
        "for f in frame_result.json project.json result.json made.db; do "
        "head -c $(($(stat -c %s $f) / 3)) $f > cut_$f; fretwork check cut_$f; test $? = 2 || exit 1; done",
        folder.path());
    EXPECT_EQ(broken.exit_code, 0) << broken.out;
    EXPECT_EQ(std::ranges::count(broken.err, '\n'), 4) << broken.err;
}

TEST(Check, TakesTheReportsThatTheProgramWrites) {
    const TemporaryFolder folder;
    const auto made = run_command(
        "fretwork tile experiments/outlines/specimen.svg --patterns 0-1+1-6 --out project.json && "
        "fretwork case add project.json experiments/cases/own_weight.json && "
        "fretwork simulate project.json --model corotational --out result.json && "
        "fretwork beams project.json result.json --strength 40MPa --out beams.json && "
        "fretwork export project.json --content facts --case own-weight --to facts.json && "
        "fretwork export project.json --to picture.png",
        folder.path());
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const auto outcome = run_command("fretwork check beams.json facts.json picture.png", folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "beams.json: valid fretwork/beams/2\nfacts.json: valid fretwork/facts/3\n"
              "picture.png: valid image (png)\n");
}

TEST(Check, NamesThePlaceInAReport) {
    const TemporaryFolder folder;
    const std::string beam =
        R"({"format":"fretwork/beams/2","joints":"stiff","strength":null,"utilization_formula":"none",
            "unknown_beams":0,"beams":[{"beam":-1}]})";
    write(folder.path() / "beams.json", beam);
    const auto outcome = run_command("fretwork check beams.json", folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("/beams/0"));
}

/// Somebody holds the pipe open and writes nothing: a reader would wait.
TEST(Check, RefusesWhatIsNoFile) {
    const TemporaryFolder folder;
    const auto pipe = folder.path() / "pipe.json";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const int writer = ::open(pipe.c_str(), O_RDWR | O_CLOEXEC);
    const auto outcome = run_command("fretwork check pipe.json /dev/zero .", folder.path());
    ::close(writer);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("pipe.json: is a pipe or a device, where a file is needed"));
    EXPECT_THAT(outcome.err, HasSubstr("/dev/zero: is a pipe or a device, where a file is needed"));
    EXPECT_THAT(outcome.err, HasSubstr("is a folder"));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 3) << outcome.err;
}

TEST(Check, ShowsControlCharactersOfNames) {
    const TemporaryFolder folder;
    const std::string name = "a\x1b[31m\nb\xff.json";
    write(folder.path() / name, text_of("setting.json"));
    const auto outcome = run_command("fretwork check *b*.json", folder.path());
    EXPECT_EQ(outcome.out, "a\\x1b[31m\\x0ab\\xff.json: valid fretwork/setting/2\n") << outcome.err;
    const auto json = run_command("fretwork check *b*.json --json", folder.path());
    EXPECT_EQ(json.exit_code, 0) << json.err;
    EXPECT_THAT(json.out, testing::Not(HasSubstr("\x1b")));
}

TEST(Check, RefusesALayoutThatNoFileUses) {
    const TemporaryFolder folder;
    const std::string paint = R"({"format":"fretwork/painting/1","layout":"paper7","patterns":["0-1+1-6"]})";
    write(folder.path() / "painting.json", paint);
    test::expect_refused("fretwork check experiments/settings/paper.json --layout paper7", folder.path(),
                         "--layout: is for paintings, and none of the files is one");
    test::expect_refused("fretwork check experiments/settings/paper.json --layout nosuch", folder.path(),
                         "--layout: unknown layout 'nosuch'");
    const auto outcome = run_command(
        "fretwork check painting.json experiments/settings/paper.json --layout paper7", folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Check, TakesTheOwnLayoutOfAPaintingFromTheOptionOnly) {
    const TemporaryFolder folder;
    const auto painting = [&](const std::string& layout) {
        write(folder.path() / "painting.json",
              R"({"format":"fretwork/painting/1","layout":")" + layout + R"(","patterns":["0-1"]})");
    };
    write(folder.path() / "one.json", text_of("layout.json"));
    painting("one");
    test::expect_refused(
        "fretwork check painting.json", folder.path(),
        "painting.json: /layout: is \"one\", where a built-in layout is needed (paper7, paper8, ");
    test::expect_refused("fretwork check painting.json", folder.path(),
                         "); for a layout of your own, add --layout FILE.json");
    const auto outcome = run_command("fretwork check painting.json --layout one.json", folder.path());
    EXPECT_EQ(outcome.out, "painting.json: valid fretwork/painting/1\n") << outcome.err;
    painting("one.json");
    test::expect_refused("fretwork check painting.json --layout one.json", folder.path(),
                         R"(painting.json: /layout: is "one.json", where the layout in use is "one")");
}

/// The name is no path: a check would blame the file there, or wait for a pipe.
TEST(Check, OpensNoFileThatAPaintingNames) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder.path() / "pipe.json").c_str(), 0600), 0);
    write(folder.path() / "valid.json", text_of("layout.json"));
    write(folder.path() / "broken.json", "{]");
    for (const std::string path :
         {"valid.json", "broken.json", "none.json", "./pipe.json", "/etc/passwd", ""}) {
        write(folder.path() / "painting.json",
              R"({"format":"fretwork/painting/1","layout":")" + path + R"(","patterns":["0-1"]})");
        test::expect_refused("fretwork check painting.json", folder.path(),
                             "fretwork: painting.json: /layout: is \"" + path + "\", where a built-in");
    }
}

TEST(Check, OneBadFileFailsAllAndTheRestIsChecked) {
    const TemporaryFolder folder;
    write(folder.path() / "notes.txt", "no file of fretwork");
    const auto outcome =
        run_command("fretwork check notes.txt missing.json experiments/settings/paper.json", folder.path());
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "experiments/settings/paper.json: valid fretwork/setting/1\n");
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 2) << outcome.err;
    const auto json =
        run_command("fretwork check notes.txt experiments/settings/paper.json --json", folder.path());
    EXPECT_EQ(json.exit_code, 2);
    EXPECT_EQ(json.err, "");
    EXPECT_THAT(json.out, HasSubstr("\"valid\": false"));
    EXPECT_THAT(json.out, HasSubstr("\"kind\": \"fretwork/setting/1\""));
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

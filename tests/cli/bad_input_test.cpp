// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a person meets it: exit code 2, one line on stderr, nothing on stdout, and no file
// half-written.
#include "cli/refusal.hpp"

namespace fretwork::app {
namespace THIS_TEST {

using test::expect_refused;
using test::Outcome;
using test::run_command;
using test::TemporaryFolder;

TEST(CommandLine, RefusesWrongUsage) {
    const TemporaryFolder folder;
    const Outcome alone = run_command("fretwork", folder.path());
    EXPECT_EQ(alone.exit_code, 2);
    EXPECT_THAT(alone.out, testing::HasSubstr("Usage: fretwork"));
    expect_refused("fretwork enumerat", folder.path(), "did you mean 'enumerate'?");
    expect_refused("fretwork enumerate --layuot paper7", folder.path(), "--layuot");
    expect_refused("fretwork enumerate --layout nowhere.json", folder.path(), "nowhere.json");
    expect_refused("fretwork enumerate --layout papre7", folder.path(), "did you mean 'paper7'?");
    expect_refused("fretwork enumerate --edges 5..2", folder.path(), "5..2");
    expect_refused("fretwork enumerate --min-angle nan", folder.path(), "nan");
    expect_refused("fretwork tile", folder.path(), "required");
    expect_refused("fretwork solve frame.json --out result.json", folder.path(), "frame.json");
    expect_refused("fretwork simulate nothing.json --out r.json", folder.path(), "nothing.json");
    expect_refused("fretwork compare a.json b.json", folder.path(), "a.json");
    expect_refused("fretwork export nothing.json --to x.svg", folder.path(), "nothing.json");
    expect_refused("fretwork library list --library none.db", folder.path(), "none.db");
    expect_refused("fretwork calibrate --library none.db", folder.path(), "none.db");
}

TEST(CommandLine, RefusesComparisonsThatMakeNoSense) {
    const TemporaryFolder folder;
    (void)folder.file("known.csv", "problem,best_value,scale,found_by\nanalytic/beale,0,1,construction\n");
    (void)folder.file("other.csv", "pattern,edges\n");
    (void)folder.file("short.csv", "problem,best_value,scale,found_by\nanalytic/beale,0\n");
    const std::string run = "fretwork optimizers run --out new --known ";
    expect_refused("fretwork optimizers", folder.path(), "subcommand");
    expect_refused(run + "none.csv", folder.path(), "none.csv");
    expect_refused(run + "other.csv", folder.path(), "other.csv: line 1");
    expect_refused(run + "short.csv", folder.path(), "short.csv: line 2");
    expect_refused(run + "known.csv --problems calibration", folder.path(), "calibration");
    expect_refused(run + "known.csv --problems analytic:0", folder.path(), "analytic:0");
    expect_refused(run + "known.csv --optimizers bobiqa", folder.path(), "did you mean 'bobyqa'?");
    expect_refused(run + "known.csv --repetitions 0", folder.path(), "repetitions: 0");
    expect_refused(run + "known.csv --budget 0", folder.path(), "budget");
}

TEST(CommandLine, RefusesBrokenFiles) {
    const TemporaryFolder folder;
    folder.file("truncated.json", R"({"format": "fretwork/frame/1", "nodes": [[0,0)");
    folder.file("nan.json", R"({"format": "fretwork/frame/1", "nodes": [[NaN,0,0]]})");
    folder.file("other.json", R"({"format": "fretwork/layout/1"})");
    folder.file("bow.json", R"({"format": "fretwork/outline/1", "boundary": [[0,0],[1,1],[1,0],[0,1]]})");
    folder.file("text.db", "this is not a library");
    expect_refused("fretwork solve truncated.json --out r.json", folder.path(), "truncated.json: line 1");
    expect_refused("fretwork solve nan.json --out r.json", folder.path(), "nan.json: line 1");
    expect_refused("fretwork solve other.json --out r.json", folder.path(), "fretwork/frame/1");
    expect_refused("fretwork enumerate --layout other.json", folder.path(), "other.json");
    expect_refused("fretwork tile bow.json --patterns 0-1+1-6 --out p.json", folder.path(), "bow.json");
    expect_refused("fretwork tile other.json --patterns 0-1+1-6 --out p.json", folder.path(), "other.json");
    expect_refused("fretwork library list --library text.db", folder.path(), "text.db");
}

TEST(CommandLine, NeverWritesOverWhatItReads) {
    const TemporaryFolder folder;
    folder.file("frame.json", "{}");
    expect_refused("fretwork solve frame.json --out frame.json", folder.path(), "frame.json");
    expect_refused("fretwork solve frame.json --out ./r.json --vtu r.json", folder.path(), "two outputs");
    expect_refused("fretwork enumerate --census t.csv --list t.csv", folder.path(), "two outputs");
    expect_refused("fretwork solve frame.json --solver linear --steps 4 --out r.json", folder.path(),
                   "newton");
    expect_refused("fretwork enumerate --edges 99", folder.path(), "17 candidate edges");
    expect_refused("fretwork enumerate --sample 2 --seed -1", folder.path(), "-1");
    expect_refused("fretwork enumerate --count --seed 2", folder.path(), "--seed works with --sample");
    expect_refused("fretwork enumerate --estimate 100 --list l.txt", folder.path(), "excludes --estimate");
    expect_refused("fretwork enumerate --sample 2 --svg s.svg --reasons", folder.path(), "excludes");
    expect_refused("fretwork enumerate --beam-width 3mm", folder.path(), "--beam-width works with --svg");
    expect_refused("fretwork enumerate --classes -", folder.path(),
                   "a table of classes, whose name ends in .csv");
    folder.file("escape.json", R"({"format": "fretwork/frame/1", "\u001b[31m": 1})");
    expect_refused("fretwork solve escape.json --out r.json", folder.path(), "x1b");
}

TEST(CommandLine, RefusesToWriteWhereItCannot) {
    const TemporaryFolder folder;
    expect_refused("fretwork enumerate --edges 3 >/dev/full", folder.path(), "standard output");
    expect_refused("fretwork enumerate --census nowhere/t.csv", folder.path(), "nowhere/t.csv");
    expect_refused("fretwork enumerate --census /dev/full", folder.path(), "/dev/full");
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

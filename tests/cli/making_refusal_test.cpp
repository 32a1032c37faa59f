// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces and options that `fretwork export` refuses to cut and to print.
#include "cli/making.hpp"

namespace fretwork::app {
namespace THIS_TEST {

class RefusedMaking : public test::Making {};

TEST_F(RefusedMaking, LengthsThatAreNone) {
    for (const std::string option : {"--kerf", "--fillet", "--frame", "--bolts", "--eye", "--fit"}) {
        for (const std::string value : {"0", "-1mm", "1kg", "inf", "nan", "''"})
            refuse("--to x.dxf --bed 300x300 " + option + "=" + value, option);
    }
    for (const std::string option : {"--layer", "--clearance"})
        for (const std::string value : {"0", "-1mm", "1kg"})
            refuse("--to x.json --content facts " + option + "=" + value, option);
}

TEST_F(RefusedMaking, LengthsThatTheSurfaceHasNoRoomFor) {
    refuse("--to x.dxf --kerf 5", "did you mean 5mm?");
    refuse("--to x.dxf --fillet 0.5", "did you mean 0.5mm?");
    refuse("--to x.dxf --kerf 5m", "the kerf is 5 m");
    refuse("--to x.dxf --frame 5m", "the width of the frame is 5 m");
    refuse("--to x.stl --case held --bolts 3mm --eye 5m", "the diameter of eyes is 5 m");
    refuse("--to x.dxf --case held --bolts 3mm --eye 2mm", "the diameter of eyes");
    refuse("--to x.dxf --case held --bolts 3mm --kerf 4mm", "kerf");
    refuse("--to x.dxf --case held --bolts 179.9mm --eye 181mm --bed 150x150", "bed");
}

TEST_F(RefusedMaking, BedsThatAreNoneOrTooSmall) {
    for (const std::string bed :
         {"600", "600x", "x400", "600x0", "-600x400", "600xabc", "nanxnan", "1e999x1"})
        refuse("--to x.dxf --bed=" + bed, "--bed");
    refuse("--to x.dxf --bed 20x20", "does not fit the bed");
}

TEST_F(RefusedMaking, OptionsWithoutAnEffect) {
    refuse("--to x.dxf --bolts 3mm", "--bolts: needs --case");
    refuse("--to x.dxf --eye 3mm", "--bolts");
    refuse("--to x.dxf --fit 0.1mm", "--bed");
    refuse("--to x.stl --bed 200x200", "is for what is cut");
    refuse("--to x.vtu --fillet 0.1mm", "is for what is cut or printed");
    refuse("--to x.stl --kerf 0.1mm", "is for what is cut");
    refuse("--to x.svg --frame 3mm", "is for what is cut or printed");
    refuse("--to x.dxf --layer 0.1mm", "is for --content facts");
    refuse("--to x.dxf --clearance 1mm", "is for --content facts");
}

TEST_F(RefusedMaking, ContentsThatAFileCannotHoldAndWriteNoneOfTheOthers) {
    refuse("--to x.dxf --content cutt", "did you mean 'cut'?");
    refuse("--to x.stl --content cut", ".stl holds: solid");
    refuse("--to good.dxf --to x.stl --content cut", "x.stl");
    refuse("--to good.dxf --to x.abc", "x.abc");
    refuse("--to good.dxf --to nowhere/x.stl", "nowhere/x.stl");
}

}  // namespace THIS_TEST
}  // namespace fretwork::app

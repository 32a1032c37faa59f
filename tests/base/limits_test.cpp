// SPDX-License-Identifier: GPL-3.0-or-later
#include "support.hpp"

#include <fretwork/base/limits.hpp>

#include <cmath>
#include <limits>

namespace fretwork::base {
namespace THIS_TEST {

constexpr Limits kAllLimits[] = {kLengthLimits,  kAreaLimits,         kSecondMomentLimits,
                                 kModulusLimits, kDensityLimits,      kForceLimits,
                                 kMomentLimits,  kAccelerationLimits, kAngleLimits};

TEST(Limits, LeaveOutWhatIsNoNumber) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const Limits& limits : kAllLimits) {
        for (const double value : {infinity, -infinity, std::nan("")}) {
            EXPECT_FALSE(is_within(value, limits)) << limits.unit;
            EXPECT_FALSE(is_positive_within(value, limits)) << limits.unit;
        }
        EXPECT_TRUE(is_within(0.0, limits)) << limits.unit;
        EXPECT_FALSE(is_positive_within(0.0, limits)) << limits.unit;
    }
}

// The stiffness of a beam is the largest and the smallest product of inputs that solvers form.
TEST(Limits, KeepStiffnessesAndTheirInversesFinite) {
    const auto bending = [](double modulus, double second_moment, double length) {
        return 12.0 * modulus * second_moment / (length * length * length);
    };
    const double stiffest = bending(kModulusLimits.most, kSecondMomentLimits.most, kLengthLimits.least);
    const double softest = bending(kModulusLimits.least, kSecondMomentLimits.least, kLengthLimits.most);
    EXPECT_TRUE(std::isnormal(stiffest * stiffest));
    EXPECT_TRUE(std::isnormal(softest * softest));
    EXPECT_TRUE(std::isnormal(kForceLimits.most / softest));
}

TEST(Limits, AreToldWithTheirUnit) {
    EXPECT_EQ(positive_range_text(kModulusLimits), "a number from 1e-12 to 1e+18 (Pa)");
    EXPECT_EQ(range_text(kForceLimits), "a number from -1e+18 to 1e+18 (N)");
}

}  // namespace THIS_TEST
}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels of the factorization as they are compiled for one instruction set each. The program itself
// picks one of them when it starts.
#include "sample.hpp"

#include <fretwork/mechanics/sparse/dense_ldlt.hpp>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <limits>

namespace fretwork::mechanics::sparse {

// tests/mechanics/CMakeLists.txt compiles dense_ldlt.cpp three times under these names.
#define FRETWORK_KERNELS(set)                                                                         \
    Pivots eliminate_##set(const Front&, const ZeroPivot&, std::vector<double>&, const Concurrency&); \
    void substitute_forward_##set(const Front&, double*, double*);                                    \
    void substitute_back_##set(const Front&, double*, const double*);                                 \
    constexpr Kernels k_##set = {eliminate_##set, substitute_forward_##set, substitute_back_##set};

struct Kernels {
    Pivots (*eliminate)(const Front&, const ZeroPivot&, std::vector<double>&, const Concurrency&);
    void (*forward)(const Front&, double*, double*);
    void (*back)(const Front&, double*, const double*);
};

FRETWORK_KERNELS(plain)
FRETWORK_KERNELS(v3)
FRETWORK_KERNELS(v4)
constexpr Kernels k_chosen = {eliminate, substitute_forward, substitute_back};

namespace THIS_TEST {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Answer {
    MatrixXd panel;
    MatrixXd rest;
    VectorXd solution;
};

VectorXd random_vector(Eigen::Index size, std::uint64_t seed) {
    sample::Random random(seed);
    VectorXd v(size);
    for (double& entry : v) entry = random.next();
    return v;
}

Answer answer_of(const Kernels& kernels, int width, int rows) {
    const int size = width + rows;
    Answer result{MatrixXd(size, width), MatrixXd::Zero(rows, rows), random_vector(size, 2)};
    result.panel.reshaped() = random_vector(result.panel.size(), 1);
    for (int i = 0; i < width; ++i) result.panel(i, i) += (i % 3 == 0 ? -3.0 : 3.0) * size;
    const VectorXd diagonal = result.panel.diagonal();
    const Front front{width, rows, result.panel.data(), result.rest.data()};
    std::vector<double> scratch;
    EXPECT_EQ(
        kernels.eliminate(front, {{diagonal.data(), static_cast<std::size_t>(width)}, 1e-14}, scratch, {})
            .zero,
        -1);
    kernels.forward(front, result.solution.data(), result.solution.data() + width);
    kernels.back(front, result.solution.data(), result.solution.data() + width);
    for (int j = 0; j < width; ++j)
        result.panel.col(j).head(j).setZero();  // the upper triangle may hold anything
    result.rest.triangularView<Eigen::StrictlyUpper>().setZero();
    return result;
}

struct Shape {
    int width;
    int rows;
};
constexpr Shape kShapes[] = {{1, 0},   {3, 2},   {6, 9},    {7, 13}, {18, 24},
                             {31, 47}, {140, 6}, {140, 47}, {300, 5}};

void expect_same_bits(const Kernels& one, const Kernels& other) {
    for (const auto& [width, rows] : kShapes) {
        const Answer a = answer_of(one, width, rows);
        const Answer b = answer_of(other, width, rows);
        EXPECT_TRUE(a.panel == b.panel) << width << " " << rows;
        EXPECT_TRUE(a.rest == b.rest) << width << " " << rows;
        EXPECT_TRUE(a.solution == b.solution) << width << " " << rows;
    }
}

/// The features by which the levels v3 and v4 of x86-64 differ for these kernels.
bool has_fused_products() {
    return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
}
bool has_wide_vectors() {
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512vl") != 0 &&
           __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512cd") != 0;
}

TEST(InstructionSets, WithFusedMultiplyAddGiveTheSameBits) {
    if (!has_fused_products() || !has_wide_vectors()) GTEST_SKIP() << "this processor has but one of them";
    expect_same_bits(k_v3, k_v4);
}

TEST(InstructionSets, TheOneThatIsChosenGivesTheBitsOfItsKind) {
    expect_same_bits(k_chosen, has_fused_products() ? k_v3 : k_plain);
}

TEST(InstructionSets, WithAndWithoutFusedMultiplyAddDifferByRoundingAlone) {
    if (!has_fused_products()) GTEST_SKIP() << "this processor has no fused multiply-add";
    bool differ = false;
    for (const auto& [width, rows] : kShapes) {
        const Answer plain = answer_of(k_plain, width, rows);
        const Answer fused = answer_of(k_v3, width, rows);
        // Sums of up to width products of numbers below 1, beside pivots of 3 (width + rows).
        const double tolerance = 4.0 * width * std::numeric_limits<double>::epsilon();
        EXPECT_LT((plain.panel - fused.panel).cwiseAbs().maxCoeff(), tolerance * 3.0 * (width + rows));
        EXPECT_LT((plain.solution - fused.solution).cwiseAbs().maxCoeff(), tolerance);
        differ = differ || plain.solution != fused.solution;
    }
    EXPECT_TRUE(differ) << "or the sets are not what they are called";
}

}  // namespace THIS_TEST
}  // namespace fretwork::mechanics::sparse

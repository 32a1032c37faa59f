// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// The build is for any machine of its architecture. Functions that begin with this macro come in several
/// versions where the compiler can make them, and the machine picks one when the program starts. (The
/// sanitizers do not run that early.) A function that such a one calls must be inlined into it by the second
/// macro, or it is compiled for any machine. The first two versions give the same bits if all products are
/// fused with the sums that they go into: no sum may be of two products. With avx512f alone, short strips
/// would not be fused.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) &&                   \
    !defined(FRETWORK_ONE_INSTRUCTION_SET)
#define FRETWORK_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define FRETWORK_CLONES
#endif
#define FRETWORK_INLINE inline __attribute__((always_inline))

namespace fretwork::base {

/// Neighbouring numbers that the machine adds and multiplies at once.
using Strip8 = double __attribute__((vector_size(64), aligned(8), may_alias));
using Strip4 = double __attribute__((vector_size(32), aligned(8), may_alias));
using Strip2 = double __attribute__((vector_size(16), aligned(8), may_alias));

template <class Strip>  // NOLINTNEXTLINE(bugprone-sizeof-expression): a vector of the compiler, no pointer
constexpr std::ptrdiff_t kRowsOf = sizeof(Strip) / sizeof(double);

/// Whether the machine has 32 vector registers of eight numbers, as the first of the versions needs.
inline bool has_many_registers() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
           __builtin_cpu_supports("avx512cd") != 0;
#else
    return false;
#endif
}

template <int Count>
struct Dots {
    double of[Count];
};

/// The products of `Count` neighbouring columns with x, at once: one alone would wait for each of its sums.
/// @param stride  distance of two columns, at least their `rows`
template <int Count>
FRETWORK_INLINE Dots<Count> dots(const double* columns, std::ptrdiff_t stride, std::ptrdiff_t rows,
                                 const double* x) {
    Strip4 sum[Count] = {};
    Dots<Count> rest{};
    std::ptrdiff_t i = 0;
    for (; i + 4 <= rows; i += 4) {
        const Strip4 strip = *reinterpret_cast<const Strip4*>(x + i);
        for (int c = 0; c < Count; ++c)
            sum[c] += *reinterpret_cast<const Strip4*>(columns + i + c * stride) * strip;
    }
    for (; i < rows; ++i) {
        for (int c = 0; c < Count; ++c) rest.of[c] += columns[i + c * stride] * x[i];
    }
    for (int c = 0; c < Count; ++c)
        rest.of[c] = (sum[c][0] + sum[c][1]) + (sum[c][2] + sum[c][3]) + rest.of[c];
    return rest;
}

}  // namespace fretwork::base

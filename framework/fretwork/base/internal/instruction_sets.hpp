// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstring>

/// FRETWORK_CLONES compiles a function in several versions, because the program is built for any machine of
/// its architecture. The program picks a version when it starts; the sanitizers are not ready then, so builds
/// with them have one version. A function called from such a function needs FRETWORK_INLINE; without it, the
/// called function is compiled for any machine. The first two versions fuse each product with its sum. Both
/// give the same bits only if no sum has two products as terms. The first version needs more than avx512f,
/// because with avx512f alone, short strips would not be fused.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && __GNUC__ >= 12 && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) &&                   \
    !defined(FRETWORK_ONE_INSTRUCTION_SET)
#define FRETWORK_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define FRETWORK_CLONES
#endif
#define FRETWORK_INLINE inline __attribute__((always_inline))

namespace fretwork::base {

/// Neighbouring numbers that vector instructions add or multiply all at once.
using Strip8 = double __attribute__((vector_size(64)));
using Strip4 = double __attribute__((vector_size(32)));
using Strip2 = double __attribute__((vector_size(16)));

template <class Strip>  // NOLINTNEXTLINE(bugprone-sizeof-expression): a vector of the compiler, no pointer
constexpr std::ptrdiff_t kRowsOf = sizeof(Strip) / sizeof(double);

/// True if the machine has 32 vector registers of eight numbers, which the first version needs.
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

/// Read a strip from any address: a matrix aligns no more than its first column. Strips are not passed by
/// value, because that depends on the instruction set.
template <class Strip>
FRETWORK_INLINE void read_strip(const double* from, Strip& strip) {
    std::memcpy(&strip, from, sizeof(Strip));
}

template <class Strip>
FRETWORK_INLINE void write_strip(const Strip& strip, double* to) {
    std::memcpy(to, &strip, sizeof(Strip));
}

template <int Count>
struct Dots {
    double of[Count];
};

/// The scalar products of `Count` neighbouring columns with x. They are computed together, because a single
/// one would wait for each of its sums.
/// @param stride  distance between two columns, at least `rows`
template <int Count>
FRETWORK_INLINE Dots<Count> dots(const double* columns, std::ptrdiff_t stride, std::ptrdiff_t rows,
                                 const double* x) {
    Strip4 sum[Count] = {};
    Dots<Count> rest{};
    std::ptrdiff_t i = 0;
    for (; i + 4 <= rows; i += 4) {
        Strip4 strip;
        read_strip(x + i, strip);
        for (int c = 0; c < Count; ++c) {
            Strip4 column;
            read_strip(columns + i + c * stride, column);
            sum[c] += column * strip;
        }
    }
    for (; i < rows; ++i) {
        for (int c = 0; c < Count; ++c) rest.of[c] += columns[i + c * stride] * x[i];
    }
    for (int c = 0; c < Count; ++c)
        rest.of[c] = (sum[c][0] + sum[c][1]) + (sum[c][2] + sum[c][3]) + rest.of[c];
    return rest;
}

}  // namespace fretwork::base

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

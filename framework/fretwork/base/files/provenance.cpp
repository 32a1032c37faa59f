// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/files/provenance.hpp>

#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

namespace fretwork::base {
namespace {

/// The last bits of a result depend on more than the program: fused multiply-add is used where the processor
/// has it, by our kernels and by the C library's functions.
std::string arithmetic() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    const std::string products =
        __builtin_cpu_supports("x86-64-v3") != 0 ? "x86-64-v3, with fused multiply-add" : "x86-64 before v3";
#else
    const std::string products = "as compiled";
#endif
#ifdef __GLIBC__
    return products + ", GNU C library " + gnu_get_libc_version();
#else
    return products + ", another C library";
#endif
}

}  // namespace

std::string version() {
    return FRETWORK_VERSION;
}

std::vector<std::pair<std::string, std::string>> provenance() {
    return {{"fretwork_version", FRETWORK_VERSION}, {"fretwork_commit", FRETWORK_COMMIT},
            {"compiler", FRETWORK_COMPILER},        {"build_type", FRETWORK_BUILD_TYPE},
            {"processor", FRETWORK_PROCESSOR},      {"arithmetic", arithmetic()}};
}

}  // namespace fretwork::base

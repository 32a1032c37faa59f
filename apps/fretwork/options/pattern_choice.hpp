// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/library/library.hpp>

#include <string>
#include <vector>

namespace fretwork::app {

/// The patterns that --patterns asks for, in the library's order: "all", "computed" for those with responses,
/// ids joined by commas, or "sample:N" for N of them spread over the numbers of edges. Throws InputError.
std::vector<pattern::NamedPattern> wanted_patterns(const library::Library& library,
                                                   const std::string& choice);

/// Every N-th of them, beginning with the I-th, for --shard I/N; all of them for "". Throws InputError.
std::vector<pattern::NamedPattern> in_shard(std::vector<pattern::NamedPattern> patterns,
                                            const std::string& shard);

}  // namespace fretwork::app

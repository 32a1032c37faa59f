// SPDX-License-Identifier: GPL-3.0-or-later
#include "enumerate_output.hpp"

#include <fretwork/library/library.hpp>
#include <fretwork/reduction/setting.hpp>

#include <filesystem>

namespace fretwork::app {

void add_to_library(const pattern::NodeLayout& layout, std::span<const pattern::Pattern> patterns,
                    const std::string& path) {
    auto library = std::filesystem::exists(path)
                       ? library::Library::open(path, library::Access::ReadWrite)
                       : library::Library::create(path, layout, reduction::paper_setting());
    library.check_layout(layout);
    library.add_patterns(patterns);
}

}  // namespace fretwork::app

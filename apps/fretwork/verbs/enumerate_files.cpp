// SPDX-License-Identifier: GPL-3.0-or-later
#include "verbs/enumerate_files.hpp"

#include <fretwork/base/error.hpp>
#include <fretwork/library/library.hpp>
#include <fretwork/reduction/scenarios/setting.hpp>

#include <filesystem>
#include <utility>

namespace fretwork::app {
namespace {

/// Sheets of more patterns are too large to look at.
constexpr std::size_t kMostOnASheet = 5000;
/// Patterns kept for a library or for classes take some hundred bytes each until the files are written.
constexpr std::size_t kMostKept = 10'000'000;

void refuse_number(const std::string& path, std::size_t most, const char* purpose) {
    throw base::InputError(path, "",
                           "there are more than " + std::to_string(most) + " patterns, too many for " +
                               purpose + "; choose fewer --edges, or --sample some");
}

}  // namespace

PatternFiles::PatternFiles(const pattern::NodeLayout& layout, PatternFilePaths paths,
                           const exports::PatternDrawingOptions& drawing)
    : layout_(layout), paths_(std::move(paths)), drawing_(drawing) {
    if (!paths_.list.empty()) list_.emplace(paths_.list);
}

bool PatternFiles::are_wanted() const {
    return !(paths_.list.empty() && paths_.library.empty() && paths_.sheet.empty() && paths_.classes.empty());
}

void PatternFiles::take(const pattern::Pattern& found) {
    if (list_) list_->write(pattern_id(layout_, found) + "\n");
    if (paths_.library.empty() && paths_.sheet.empty() && paths_.classes.empty()) return;
    check_number();
    kept_.push_back(found);
}

void PatternFiles::check_number() const {
    if (!paths_.sheet.empty() && kept_.size() == kMostOnASheet)
        refuse_number(paths_.sheet, kMostOnASheet, "one sheet");
    if (kept_.size() < kMostKept) return;
    if (!paths_.library.empty()) refuse_number(paths_.library, kMostKept, "a library");
    refuse_number(paths_.classes, kMostKept, "their classes");
}

std::optional<pattern::SamenessReport> PatternFiles::finish(const pattern::SamenessOptions& options) {
    std::optional<pattern::SamenessReport> sameness;
    if (!paths_.classes.empty()) {
        sameness = pattern::find_sameness(layout_, kept_, options);
        others_.add(paths_.classes, pattern::sameness_csv(layout_, kept_, *sameness));
    }
    if (!paths_.sheet.empty())
        others_.add(paths_.sheet, exports::pattern_sheet_svg(layout_, kept_, drawing_));
    options.control.check();
    if (!paths_.library.empty()) add_to_library(options.control);
    if (list_) list_->commit();
    others_.commit();
    return sameness;
}

/// An existing library keeps its setting. A new one gets the paper's, until it is calibrated with another.
void PatternFiles::add_to_library(const base::Control& control) const {
    std::error_code is_missing;
    auto library = std::filesystem::file_size(paths_.library, is_missing) > 0 && !is_missing
                       ? library::Library::open(paths_.library, library::Access::ReadWrite)
                       : library::Library::open_or_create(paths_.library, layout_, reduction::paper_setting(),
                                                          kept_, control);
    library.check_layout(layout_);
    library.add_patterns(kept_, control);
}

}  // namespace fretwork::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/files/file.hpp>
#include <fretwork/exports/drawings/pattern_drawing.hpp>
#include <fretwork/pattern/sameness.hpp>

#include <optional>
#include <string>
#include <vector>

namespace fretwork::app {

/// The files that valid patterns go to; empty: not wanted.
struct PatternFilePaths {
    std::string list;     ///< ids, one a line
    std::string library;  ///< gets the patterns; made if it is not there
    std::string sheet;    ///< a drawing of all of them
    std::string classes;  ///< table of mirror images and isomorphism classes
};

/// Makes all wanted files from the patterns of one search or sample. No file is in its place before finish().
///
/// The list is written as patterns come. The other files need all patterns at once: take() refuses a pattern
/// if there are then too many for the memory or for one sheet.
class PatternFiles {
  public:
    /// Begin the files. `layout` must outlive this object.
    PatternFiles(const pattern::NodeLayout& layout, PatternFilePaths paths,
                 const exports::PatternDrawingOptions& drawing);

    [[nodiscard]] bool are_wanted() const;
    /// Add a valid pattern. Throws InputError if this is one pattern too many for a file that is wanted.
    void take(const pattern::Pattern& found);
    /// Add another file, which finish() puts in its place with the others.
    void add(const std::string& path, std::string_view content) { others_.add(path, content); }
    /// Put all files in their places. Returns the content of the table of classes; nothing if this table is
    /// not wanted. Throws base::Stopped.
    std::optional<pattern::SamenessReport> finish(const pattern::SamenessOptions& options);

  private:
    void check_number() const;
    void add_to_library(const base::Control& control) const;

    const pattern::NodeLayout& layout_;
    PatternFilePaths paths_;
    exports::PatternDrawingOptions drawing_;
    std::optional<base::AtomicFile> list_;
    base::FileBatch others_;
    std::vector<pattern::Pattern> kept_;
};

}  // namespace fretwork::app

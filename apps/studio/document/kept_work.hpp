// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fretwork/base/internal/json_text.hpp>
#include <fretwork/base/json_reader.hpp>
#include <studio/document/autosave.hpp>
#include <studio/document/document.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace fretwork::studio {

/// A document, and the place of its autosave; none: it gets a new one.
struct Opened {
    Document document;
    std::optional<AutosavePlace> place{};
};

/// The unsaved work in a studio's state folder: that of the document that is shown, which is kept there while
/// it differs from its file, and that of studios that have ended. Used on the server's thread.
class KeptWork {
  public:
    /// @param warn    receives why the work of a document cannot be kept
    /// @param failed  receives, on another thread, why a state could not be written
    KeptWork(std::filesystem::path folder, std::function<void(const std::string&)> warn,
             std::function<void(const std::string&)> failed);

    /// From now on the work is that of another document, or of the same in another file. Without a place it
    /// takes a new one; if the folder takes no file, it warns and keeps nothing.
    ///
    /// @param document  its file; none: it was never saved
    void take_place(std::optional<AutosavePlace> place, const std::optional<std::filesystem::path>& document);
    /// The reason why work cannot be kept, in one line; empty if it is kept.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

    /// Keep the document's unsaved changes, or forget what is kept if it has none.
    void keep(const Document& document);
    /// The document is saved, or given up.
    void forget();

    /// The unsaved changes of a project file, if they are newer than the file: to undo them is to have what
    /// lies in it. Otherwise the file as it is, with a warning if the changes cannot be read.
    [[nodiscard]] Opened with_changes(Document saved, const std::filesystem::path& file) const;
    /// The list of what other studios left behind, for pages.
    [[nodiscard]] base::Json recoverable_json() const;
    /// Throws InputError if it is gone, or another studio shows it.
    [[nodiscard]] Recoverable find(const base::JsonReader& key) const;
    void forget(const Recoverable& found);

  private:
    [[nodiscard]] std::optional<AutosavePlace> new_place(
        const std::optional<std::filesystem::path>& document);

    std::filesystem::path folder_;
    std::function<void(const std::string&)> warn_;
    std::optional<AutosavePlace> place_;
    std::string trouble_;
    Autosave autosave_;
};

}  // namespace fretwork::studio

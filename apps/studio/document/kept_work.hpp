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

/// The unsaved work in a studio's state folder. The changes of the shown document are kept there while it
/// differs from its file. The folder also has the work of studios that have ended. Used on the server's
/// thread.
class KeptWork {
  public:
    /// @param warn    receives why the work of a document cannot be kept
    /// @param failed  receives, on another thread, why a state could not be written
    KeptWork(std::filesystem::path folder, std::function<void(const std::string&)> warn,
             std::function<void(const std::string&)> failed);

    /// From now on, keep the work of another document, or of the same document with another file. Without a
    /// place, a new one is taken; if the folder cannot be written, a warning is given and nothing is kept.
    ///
    /// @param document  its file; none: it was never saved
    void take_place(std::optional<AutosavePlace> place, const std::optional<std::filesystem::path>& document);
    /// The reason why work cannot be kept, in one line; empty if it is kept.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

    /// Keep the document's unsaved changes, or forget what is kept if it has none.
    void keep(const Document& document);
    /// The document is saved, or given up.
    void forget();

    /// The document of a project file with its unsaved changes, if they are newer than the file; undo leads
    /// back to the file. Otherwise the document as it is, with a warning if the changes cannot be read.
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

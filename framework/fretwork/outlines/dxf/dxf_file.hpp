// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fretwork::outlines::detail {

/// One pair of lines of an ASCII DXF file: a code and a value. The code states the meaning of the value.
struct DxfGroup {
    int code = 0;
    std::string_view value;
    int line = 0;  ///< line of the code, from 1
};

/// An entity, or a vertex of an entity: its name and groups.
struct DxfEntity {
    std::string_view name;
    int line = 0;
    std::span<const DxfGroup> groups;
    std::size_t size = 0;  ///< characters that are read each time the entity is drawn, for limits of work
};

/// The entities, blocks and layers of a file. Each function that reads a value throws InputError that names
/// file and line.
class DxfFile {
  public:
    /// Throws InputError if the text is not an ASCII DXF file, or has no section ENTITIES.
    DxfFile(std::string source, std::string text);

    struct Block {
        double base_x = 0.0;
        double base_y = 0.0;
        std::vector<DxfEntity> entities;
    };
    [[nodiscard]] const std::vector<DxfEntity>& entities() const { return entities_; }
    [[nodiscard]] const std::map<std::string, Block>& blocks() const { return blocks_; }
    /// The block with this name, or null. Case is ignored.
    [[nodiscard]] const Block* block(std::string_view name) const;
    enum class Layer { On, Off, Frozen };
    /// The state of the layer with this name; On if the file does not list it. Case is ignored.
    [[nodiscard]] Layer layer(std::string_view name) const;
    /// The value of $INSUNITS and its line; nothing if the file does not state $INSUNITS.
    [[nodiscard]] std::optional<DxfGroup> units() const { return units_; }

    [[nodiscard]] const DxfGroup* find(const DxfEntity& entity, int code) const;
    [[nodiscard]] double value(const DxfEntity& entity, int code) const;
    [[nodiscard]] double value_or(const DxfEntity& entity, int code, double missing) const;
    [[nodiscard]] long whole_or(const DxfEntity& entity, int code, long missing) const;
    [[nodiscard]] double number(const DxfGroup& group) const;
    [[nodiscard]] long whole_number(const DxfGroup& group) const;
    [[nodiscard]] std::string_view text_or(const DxfEntity& entity, int code, std::string_view missing) const;
    [[noreturn]] void fail(int line, const std::string& message) const;

  private:
    void split_groups();
    void read_sections();
    void read_header(std::span<const DxfGroup> section);
    void read_layers(std::span<const DxfGroup> section);
    void read_blocks(std::span<const DxfGroup> section);

    std::string source_;
    std::string text_;
    std::vector<DxfGroup> groups_;
    std::vector<DxfEntity> entities_;
    std::map<std::string, Block> blocks_;
    std::map<std::string, Layer> layers_;
    std::optional<DxfGroup> units_;
};

}  // namespace fretwork::outlines::detail

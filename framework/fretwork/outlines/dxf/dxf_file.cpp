// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/quantity.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/outlines/dxf/dxf_file.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace fretwork::outlines::detail {
namespace {

constexpr std::size_t kMostShown = 40;  // largest number of characters of a value in a message

std::string_view trimmed_line(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_capitals(std::string_view text) {
    std::string capitals(text);
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return capitals;
}

std::string quoted(std::string_view value) {
    return "'" + base::shortened(base::printable(value), kMostShown) + "'";
}

std::size_t size_of(std::span<const DxfGroup> groups) {
    constexpr std::size_t kCodeAndLineEnds = 3;
    constexpr int kFirstData = 300;  // text and binary data of other programs, which are passed over
    std::size_t size = 0;
    for (const DxfGroup& group : groups)
        size += kCodeAndLineEnds + (group.code < kFirstData ? group.value.size() : 0);
    return size;
}

/// The entities in a sequence of groups. Each entity begins with code 0.
std::vector<DxfEntity> entities_in(std::span<const DxfGroup> groups) {
    std::vector<DxfEntity> entities;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= groups.size(); ++i) {
        if (i < groups.size() && groups[i].code != 0) continue;
        if (!entities.empty()) {
            entities.back().groups = groups.subspan(begin, i - begin);
            entities.back().size = entities.back().name.size() + size_of(entities.back().groups);
        }
        if (i < groups.size()) entities.push_back({groups[i].value, groups[i].line, {}});
        begin = i + 1;
    }
    return entities;
}

}  // namespace

DxfFile::DxfFile(std::string source, std::string text) : source_(std::move(source)), text_(std::move(text)) {
    if (text_.starts_with("AutoCAD Binary DXF"))
        throw base::InputError(source_, "", "is a binary DXF file, where an ASCII one is needed");
    split_groups();
    read_sections();
}

void DxfFile::fail(int line, const std::string& message) const {
    throw base::InputError(source_, "line " + std::to_string(line), message);
}

void DxfFile::split_groups() {
    std::string_view rest(text_);
    const auto next_line = [&]() -> std::optional<std::string_view> {
        if (rest.empty()) return std::nullopt;
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed_line(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return line;
    };
    int line = 1;
    while (const auto code = next_line()) {
        const auto value = next_line();
        if (!value && code->empty()) return;
        if (!value) fail(line, "the file ends within a pair of code and value");
        const auto number = base::read_number<int>(*code);
        if (!number) fail(line, quoted(*code) + " is not a whole number; is this an ASCII DXF file?");
        groups_.push_back({*number, *value, line});
        line += 2;
    }
}

void DxfFile::read_sections() {
    bool has_entities = false;
    const std::span<const DxfGroup> groups(groups_);
    for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
        if (groups[i].code != 0 || groups[i].value != "SECTION" || groups[i + 1].code != 2) continue;
        const auto begin = groups.begin() + i + 2;
        const auto end = std::find_if(begin, groups.end(), [](const DxfGroup& group) {
            return group.code == 0 && group.value == "ENDSEC";
        });
        const std::string_view name = groups[i + 1].value;
        if (end == groups.end())
            throw base::InputError(
                source_, "",
                "the section " + base::shortened(base::printable(name), kMostShown) + " has no end (ENDSEC)");
        const std::span<const DxfGroup> section(begin, end);
        if (name == "HEADER") read_header(section);
        if (name == "TABLES") read_layers(section);
        if (name == "BLOCKS") read_blocks(section);
        if (name == "ENTITIES") {
            entities_ = entities_in(section);
            has_entities = true;
        }
        i = end - groups.begin();
    }
    if (!has_entities) throw base::InputError(source_, "", "has no section ENTITIES");
}

void DxfFile::read_header(std::span<const DxfGroup> section) {
    for (std::size_t i = 0; i + 1 < section.size(); ++i)
        if (section[i].code == 9 && section[i].value == "$INSUNITS") units_ = section[i + 1];
}

/// Read the states of the layers. Flag 1 means frozen; a color below zero means off.
void DxfFile::read_layers(std::span<const DxfGroup> section) {
    for (const DxfEntity& entity : entities_in(section)) {
        if (entity.name != "LAYER") continue;
        Layer state = Layer::On;
        if (value_or(entity, 62, 0) < 0) state = Layer::Off;
        if ((whole_or(entity, 70, 0) & 1L) != 0) state = Layer::Frozen;
        layers_[in_capitals(text_or(entity, 2, ""))] = state;
    }
}

void DxfFile::read_blocks(std::span<const DxfGroup> section) {
    Block* block = nullptr;
    for (const DxfEntity& entity : entities_in(section)) {
        if (entity.name == "BLOCK") {
            block = &blocks_[in_capitals(text_or(entity, 2, ""))];
            *block = {value_or(entity, 10, 0), value_or(entity, 20, 0), {}};
        } else if (entity.name == "ENDBLK") {
            block = nullptr;
        } else if (block) {
            block->entities.push_back(entity);
        }
    }
}

const DxfFile::Block* DxfFile::block(std::string_view name) const {
    const auto found = blocks_.find(in_capitals(name));
    return found == blocks_.end() ? nullptr : &found->second;
}

DxfFile::Layer DxfFile::layer(std::string_view name) const {
    const auto found = layers_.find(in_capitals(name));
    return found == layers_.end() ? Layer::On : found->second;
}

const DxfGroup* DxfFile::find(const DxfEntity& entity, int code) const {
    const auto found = std::ranges::find(entity.groups, code, &DxfGroup::code);
    return found == entity.groups.end() ? nullptr : &*found;
}

double DxfFile::number(const DxfGroup& group) const {
    const auto value = base::read_number<double>(group.value);
    if (!value || !std::isfinite(*value))
        fail(group.line + 1, quoted(group.value) + " is not a finite number");
    return *value;
}

long DxfFile::whole_number(const DxfGroup& group) const {
    const auto value = base::read_number<long>(group.value);
    if (!value) fail(group.line + 1, quoted(group.value) + " is not a whole number");
    return *value;
}

double DxfFile::value(const DxfEntity& entity, int code) const {
    const DxfGroup* group = find(entity, code);
    if (!group) fail(entity.line, std::string(entity.name) + " has no group " + std::to_string(code));
    return number(*group);
}

double DxfFile::value_or(const DxfEntity& entity, int code, double missing) const {
    const DxfGroup* group = find(entity, code);
    return group ? number(*group) : missing;
}

long DxfFile::whole_or(const DxfEntity& entity, int code, long missing) const {
    const DxfGroup* group = find(entity, code);
    return group ? whole_number(*group) : missing;
}

std::string_view DxfFile::text_or(const DxfEntity& entity, int code, std::string_view missing) const {
    const DxfGroup* group = find(entity, code);
    return group ? group->value : missing;
}

}  // namespace fretwork::outlines::detail

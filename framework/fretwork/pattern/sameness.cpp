// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/control.hpp>
#include <fretwork/base/parallel.hpp>
#include <fretwork/base/task.hpp>
#include <fretwork/pattern/detail/canonical_form.hpp>
#include <fretwork/pattern/fan.hpp>
#include <fretwork/pattern/mirror.hpp>
#include <fretwork/pattern/sameness.hpp>

#include <algorithm>
#include <unordered_map>

namespace fretwork::pattern {
namespace {

/// The number of canonical forms made at a time. Batches keep memory proportional to the number of classes,
/// not of patterns.
constexpr std::size_t kBatch = 4096;

void find_classes(const NodeLayout& layout, std::span<const Pattern> patterns, const SamenessOptions& options,
                  SamenessReport& report) {
    const base::Task task(options.control, "canonical forms", patterns.size());
    std::unordered_map<std::string, std::size_t> classes;
    for (std::size_t start = 0; start < patterns.size(); start += kBatch) {
        std::vector<std::string> forms(std::min(kBatch, patterns.size() - start));
        base::parallel_for(forms.size(), options.threads, [&](std::size_t i) {
            options.control.check();
            forms[i] = detail::canonical_form(make_fan(layout, patterns[start + i], kReferenceSides));
        });
        for (std::size_t i = 0; i < forms.size(); ++i) {
            const auto known = classes.try_emplace(std::move(forms[i]), classes.size()).first;
            report.of_pattern[start + i].isomorphism_class = known->second;
        }
        task.update(start + forms.size());
    }
    report.up_to_isomorphism = classes.size();
}

void find_mirror_partners(const NodeLayout& layout, std::span<const Pattern> patterns,
                          const base::Control& control, SamenessReport& report) {
    const Mirror mirror(layout);
    std::unordered_map<Pattern::Bits, std::size_t> positions;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        control.check();
        positions.emplace(patterns[i].bits(), i);
    }
    std::size_t paired = 0;
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        control.check();
        const std::optional<Pattern> image = mirror.image(patterns[i]);
        const auto found = image ? positions.find(image->bits()) : positions.end();
        if (found == positions.end()) continue;
        if (found->second == i) {
            report.of_pattern[i].symmetry = Symmetry::Mirror;
        } else {
            report.of_pattern[i].mirror_partner = found->second;
            ++paired;
        }
    }
    report.up_to_mirror = patterns.size() - paired / 2;
}

}  // namespace

SamenessReport find_sameness(const NodeLayout& layout, std::span<const Pattern> patterns,
                             const SamenessOptions& options) {
    SamenessReport report;
    report.of_pattern.resize(patterns.size());
    find_mirror_partners(layout, patterns, options.control, report);
    find_classes(layout, patterns, options, report);
    return report;
}

std::string sameness_csv(const NodeLayout& layout, std::span<const Pattern> patterns,
                         const SamenessReport& report) {
    std::string text = "id,edges,symmetry,mirror,class\n";
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const PatternSameness& same = report.of_pattern[i];
        text += pattern_id(layout, patterns[i]) + "," + std::to_string(patterns[i].edge_count()) + ",";
        text += same.symmetry == Symmetry::Mirror ? "mirror," : "none,";
        if (same.mirror_partner) text += pattern_id(layout, patterns[*same.mirror_partner]);
        text += "," + std::to_string(same.isomorphism_class) + "\n";
    }
    return text;
}

}  // namespace fretwork::pattern

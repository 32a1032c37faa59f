// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/base/text.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace fretwork::simulation {
namespace {

/// The load case, with an origin for each entry. In a merged list, an entry has another position.
/// @param name  name of the load case in messages about its entries; empty: none
LoadCase with_origins(LoadCase load_case, const std::string& name) {
    const auto note = [&](auto& entries, std::size_t first) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            LoadCase::Origin& origin = entries[i].origin;
            if (!origin.position) origin.position = first + i;
            if (origin.load_case.empty()) origin.load_case = name;
        }
    };
    note(load_case.supports, 0);
    note(load_case.loads, 0);
    note(load_case.area_loads, load_case.loads.size());
    note(load_case.prescribed, 0);
    return load_case;
}

void add(const LoadCase& part, double factor, LoadCase& sum) {
    sum.supports.insert(sum.supports.end(), part.supports.begin(), part.supports.end());
    for (LoadCase::Load load : part.loads) {
        load.force *= factor;
        load.moment *= factor;
        sum.loads.push_back(std::move(load));
    }
    for (LoadCase::AreaLoad load : part.area_loads) {
        load.per_area *= factor;
        sum.area_loads.push_back(std::move(load));
    }
    for (LoadCase::PrescribedDisplacement displacement : part.prescribed) {
        displacement.value *= factor;
        sum.prescribed.push_back(std::move(displacement));
    }
    sum.gravity += factor * part.gravity;
}

struct Part {
    const LoadCase* load_case;
    double factor;
};

/// The load case that another one combines. Only what it may combine is offered instead of an unknown one.
const LoadCase& combinable(const LoadCase& load_case, const std::string& name,
                           std::span<const LoadCase> cases) {
    if (name == load_case.name) throw base::InputError("is the load case itself");
    const auto part = std::ranges::find(cases, name, &LoadCase::name);
    if (part == cases.end()) {
        std::vector<std::string> others;
        for (const LoadCase& other : cases)
            if (other.combines.empty() && other.name != load_case.name) others.push_back(other.name);
        throw base::InputError(base::unknown_name_message("load case", name, others));
    }
    if (!part->combines.empty())
        throw base::InputError("'" + part->name + "' is a combination, too: name what it combines");
    return *part;
}

/// The load cases that one combines, each once: factors of a case that is named several times are added.
/// Errors have the place in the load case.
std::vector<Part> parts_of(const LoadCase& load_case, std::span<const LoadCase> cases) {
    std::vector<Part> parts;
    std::map<const LoadCase*, std::size_t> places;
    for (std::size_t i = 0; i < load_case.combines.size(); ++i) {
        const LoadCase::Share& share = load_case.combines[i];
        const std::string place = "/combines/" + std::to_string(i) + "/load_case";
        base::located("", place, [&] {
            const LoadCase& part = combinable(load_case, share.load_case, cases);
            const auto [known, is_new] = places.try_emplace(&part, parts.size());
            if (is_new) parts.push_back({&part, 0.0});
            parts[known->second].factor += share.factor;
        });
    }
    return parts;
}

/// Work on the load cases that one combines, whose errors name the load case.
template <class Work>
auto in_load_case(const LoadCase& load_case, const Work& work) {
    return base::located("load case '" + load_case.name + "'", "", work);
}

}  // namespace

const LoadCase& load_case_of(const std::string& name, std::span<const LoadCase> cases) {
    return base::find_named(name, cases, &LoadCase::name, "load case");
}

LoadCase combined(const LoadCase& load_case, std::span<const LoadCase> cases) {
    if (load_case.combines.empty()) return load_case;
    const auto parts = in_load_case(load_case, [&] { return parts_of(load_case, cases); });
    LoadCase sum = with_origins(load_case, "");
    sum.combines.clear();
    for (const Part& part : parts) add(with_origins(*part.load_case, part.load_case->name), part.factor, sum);
    return sum;
}

void check_combination(const LoadCase& load_case, std::span<const LoadCase> cases) {
    (void)parts_of(load_case, cases);
}

void check_combinations(std::span<const LoadCase> cases) {
    for (const LoadCase& load_case : cases)
        in_load_case(load_case, [&] { check_combination(load_case, cases); });
}

}  // namespace fretwork::simulation

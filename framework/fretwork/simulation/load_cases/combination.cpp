// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/base/error.hpp>
#include <fretwork/base/named.hpp>
#include <fretwork/simulation/load_cases/combination.hpp>

#include <algorithm>
#include <cstddef>

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

/// True for a share of the load case with this name.
auto names(const std::string& name) {
    return [&name](const LoadCase::Share& share) { return share.load_case == name; };
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

}  // namespace

const LoadCase& load_case_of(const std::string& name, std::span<const LoadCase> cases) {
    return base::find_named(name, cases, &LoadCase::name, "load case");
}

LoadCase combined(const LoadCase& load_case, std::span<const LoadCase> cases) {
    if (load_case.combines.empty()) return load_case;
    LoadCase sum = with_origins(load_case, "");
    sum.combines.clear();
    for (std::size_t i = 0; i < load_case.combines.size(); ++i) {
        const LoadCase::Share& share = load_case.combines[i];
        const std::string place = "/combines/" + std::to_string(i) + "/load_case";
        base::located("load case '" + load_case.name + "'", place, [&] {
            if (share.load_case == load_case.name) throw base::InputError("is itself");
            const auto end = load_case.combines.begin() + static_cast<std::ptrdiff_t>(i);
            if (std::find_if(load_case.combines.begin(), end, names(share.load_case)) != end)
                throw base::InputError("is named before: give the sum of both factors");
            const LoadCase& part = load_case_of(share.load_case, cases);
            if (!part.combines.empty())
                throw base::InputError("'" + part.name + "' is a combination, too: name what it combines");
            add(with_origins(part, part.name), share.factor, sum);
        });
    }
    return sum;
}

void check_combinations(std::span<const LoadCase> cases) {
    for (const LoadCase& load_case : cases) (void)combined(load_case, cases);
}

}  // namespace fretwork::simulation

// SPDX-License-Identifier: GPL-3.0-or-later
#include <fretwork/mechanics/internal/node_json.hpp>

#include <algorithm>

namespace fretwork::mechanics {

Dof read_dof(const base::JsonReader& json) {
    const std::string name = json.choice({"ux", "uy", "uz", "rx", "ry", "rz"});
    return static_cast<Dof>(std::ranges::find(kDofNames, name) - kDofNames.begin());
}

DofSet read_dofs(const base::JsonReader& json) {
    DofSet dofs;
    for (const base::JsonReader& name : json.elements()) dofs[read_dof(name)] = true;
    return dofs;
}

base::Json dofs_json(const DofSet& dofs) {
    base::Json names = base::Json::array();
    for (std::size_t d = 0; d < kDofsPerNode; ++d) {
        if (dofs.contains[d]) names.push_back(kDofNames[d]);
    }
    return names;
}

base::Json vector_json(const Eigen::Vector3d& vector) {
    return base::Json::array({vector.x(), vector.y(), vector.z()});
}

}  // namespace fretwork::mechanics

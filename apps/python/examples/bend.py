# SPDX-License-Identifier: GPL-3.0-or-later
"""Paint a square, bend it, and compare two tile models."""

import fretwork as fw


def main() -> None:
    square = fw.make_outline([[0.0, 0.0], [0.2, 0.0], [0.2, 0.2], [0.0, 0.2]])
    project, report = fw.make_project(square, patterns="0-1+1-6", edge_length=0.025)
    case = fw.LoadCase(
        name="tip",
        supports=[fw.LoadCase.Support(fw.NodesAtSide("left"), "all")],
        loads=[fw.LoadCase.Load(fw.NodesAtSide("right"), force=[0, 0, -0.001])],
    )
    project.load_cases += (case,)
    surface = fw.make_surface(project)
    full = fw.simulate(surface, case)
    reduced = fw.simulate(surface, case, model="corotational")
    print(f"{report.tiles} tiles, tip moves {1e3 * full.largest_displacement:.2f} mm")
    print(fw.comparison_text(fw.compare(full, reduced)))


if __name__ == "__main__":
    main()

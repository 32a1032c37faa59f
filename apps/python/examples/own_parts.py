# SPDX-License-Identifier: GPL-3.0-or-later
"""A filter, a layout, a tile model and an optimizer of one's own."""

import numpy as np
import numpy.typing as npt

import fretwork as fw


def few_beams(pattern: fw.Pattern) -> bool:
    return len(pattern) <= 4


def condensed(tile: fw.TileInput) -> npt.NDArray[np.float64]:
    return fw.condensed_frame(tile.frame(), tile.interface_nodes)


def dice(evaluator: fw.Evaluator, options: fw.OptimizerOptions) -> fw.RunOutcome:
    random = np.random.default_rng(options.seed)
    bounds = evaluator.bounds
    while evaluator.value(random.uniform(bounds.lower, bounds.upper)) is not None:
        pass
    return fw.RunOutcome("budget-spent")


def main() -> None:
    layout = fw.NodeLayout("own", radial=["1/3", "2/3"], interface=["1/2"])
    settings = fw.FilterSettings(own=[fw.Filter("many", few_beams, "has more than four beams")])
    patterns = fw.enumerate_patterns(layout, filters=settings)
    setting = fw.paper_setting()
    setting.magnitudes = 2
    model = fw.TileModel("mine", condensed)
    stiffness = fw.tile_stiffness(model, layout, patterns[0], setting)
    responses = fw.compute_responses(layout, patterns[0], setting)
    method = fw.OptimizerRow("dice", dice)
    found = fw.calibrate("paper6", layout, patterns[0], setting, responses, optimizer="dice", optimizers=[method],
                         budget=500)
    print(len(patterns), stiffness.shape, f"{found.objective:.1f}")


if __name__ == "__main__":
    main()

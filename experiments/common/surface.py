# SPDX-License-Identifier: GPL-3.0-or-later
"""One surface in one folder, as experiments tile, paint, load and solve it."""
import json
import random

from program import Fretwork

PALETTE_SIZE = 8


class Surface(Fretwork):
    """The program on outline.json, project.json and case.json of its folder."""

    def write(self, name, content):
        (self.folder / name).write_text(json.dumps(content))

    def tile(self, outline, painting, *options):
        """Tile the outline and paint it at random. Returns what the command tells. A project that is there is another surface's."""
        self.write("outline.json", outline)
        (self.folder / "project.json").unlink(missing_ok=True)
        return json.loads(self("tile", "outline.json", "--patterns", f"random:{painting}", *options, "--out", "project.json", "--json"))

    def simulate(self, model, out, *options, accepted=(0,)):
        """Solve it under case.json. Returns what the command tells."""
        return json.loads(self("simulate", "project.json", "--case", "./case.json", "--model", model, "--json", "--out", out, *options,
                               accepted=accepted))

    def compare(self, full, reduced):
        """Two results, by the names of their files."""
        return json.loads(self("compare", full, reduced, "--json"))


def palette(patterns, painting):
    """Eight of the patterns, drawn with the painting's number as the seed, as `--palette` takes them."""
    return ",".join(random.Random(painting).sample(patterns, PALETTE_SIZE))


def errors(comparison):
    """What `compare` tells, as shares of the largest displacement."""
    scale = comparison["max_displacement_m"]
    return {"mean": comparison["mean_translation_error_m"] / scale, "largest": comparison["max_translation_error_m"] / scale}

# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as a function of torch: `energy = Output.apply(function, "thickness", "energy", x)`."""

from typing import Any

import torch

import fretwork as fw


class Output(torch.autograd.Function):
    """One output of a SurfaceFunction by one part of its design."""

    @staticmethod
    def forward(ctx: Any, *args: Any, **kwargs: Any) -> Any:
        function, part, output, x = args
        ctx.call = function, part, output, x.detach().numpy().copy()
        return torch.from_numpy(fw.apply(function, {part: ctx.call[3]})[output])

    @staticmethod
    def backward(ctx: Any, *cotangents: Any) -> Any:
        function, part, output, x = ctx.call
        slopes = fw.vjp(function, {part: x}, {}, {output: cotangents[0].numpy()})[part]
        return None, None, None, torch.from_numpy(slopes)

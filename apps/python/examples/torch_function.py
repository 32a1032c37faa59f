# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface as a function of torch: `positions = Positions.apply(function, part, x)`."""

from typing import Any

import torch

import fretwork as fw


class Positions(torch.autograd.Function):
    """The positions (n x 3, m) of the interface nodes by one part of a design."""

    @staticmethod
    def forward(ctx: Any, *args: Any, **kwargs: Any) -> Any:
        function, part, x = args
        ctx.call = function, part, x.detach().numpy().copy()
        return torch.from_numpy(fw.apply(function, {part: ctx.call[2]})["positions"])

    @staticmethod
    def backward(ctx: Any, *cotangents: Any) -> Any:
        function, part, x = ctx.call
        slopes = fw.vjp(function, {part: x}, {}, {"positions": cotangents[0].numpy()})[part]
        return None, None, torch.from_numpy(slopes)

// SPDX-License-Identifier: GPL-3.0-or-later

import type { Point } from '../protocol/messages';
/** A text for --patterns, whose field is 0 at one point and 1 at another; the end patterns go on beyond. */
export function alongLine(from: Point, to: Point): string {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length2 = dx * dx + dy * dy;
  return `field:(x-(${from[0]}))*(${dx / length2})+(y-(${from[1]}))*(${dy / length2})`;
}

// SPDX-License-Identifier: GPL-3.0-or-later

import { boxOf } from '../document/surface';
import type { Point } from '../protocol/messages';

const MARGIN = 2;

interface LoopsProps {
  /** Closed polygons, y upwards. */
  loops: readonly (readonly Point[])[];
  /** Pixels that they are fitted into. */
  room: { width: number; height: number };
  class: string;
  /** Read aloud; left out: a decoration. */
  label?: string;
}

/** Polygons as one small picture, as large as there is room. */
export function Loops({ loops, room, label, ...rest }: LoopsProps) {
  const { min, max } = boxOf(loops.flat());
  const [wide, high] = [max[0] - min[0], max[1] - min[1]];
  if (!(wide > 0 && high > 0)) return null;
  const zoom = Math.min(room.width / wide, room.height / high);
  const at = ([x, y]: Point): string => `${(zoom * (x - min[0])).toFixed(1)} ${(zoom * (max[1] - y)).toFixed(1)}`;
  const path = loops.map((loop) => `M${loop.map(at).join('L')}Z`).join('');
  const [width, height] = [zoom * wide + 2 * MARGIN, zoom * high + 2 * MARGIN];
  return (
    <svg {...rest} {...(label ? { role: 'img', 'aria-label': label } : { 'aria-hidden': 'true' })} width={width} height={height} viewBox={`${-MARGIN} ${-MARGIN} ${width} ${height}`}>
      <path d={path} />
    </svg>
  );
}

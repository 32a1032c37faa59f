// SPDX-License-Identifier: GPL-3.0-or-later
// A small drawing for each example card: a field of hexagons, cut to a shape and bent.

interface Shape {
  within(x: number, y: number): boolean;
  height(x: number, y: number): number;
}
const SHAPES: Record<string, Shape> = {
  bridge: { within: (x, y) => Math.abs(x) < 1.02 && Math.abs(y) < 0.36, height: (x) => -0.34 * (1 - x * x) },
  leaf: { within: (x, y) => Math.abs(x) < 1 && Math.abs(y) < 0.5 * (1 - x * x) ** 0.7, height: (x) => 0.22 - 0.13 * (x + 1) ** 2 },
  dome: { within: (x, y) => x * x + y * y < 0.62, height: (x, y) => 0.19 * (0.62 - x * x - y * y) },
};
const SIDE = 0.105;
const SEGMENTS = [[0, 0, 0.43, 0.25], [0.43, 0.25, 0.87, 0], [0.43, 0.25, 0, 0.5], [0, 0, 0.87, 0]];
const [WIDTH, HEIGHT, ZOOM] = [300, 120, 118];

function seen(x: number, y: number, z: number): string {
  return `${(WIDTH / 2 + ZOOM * (0.94 * x + 0.3 * y)).toFixed(1)} ${(HEIGHT / 2 - ZOOM * (0.42 * y - 0.1 * x + 0.8 * z)).toFixed(1)}`;
}

function fieldPath({ within, height }: Shape): string {
  let path = '';
  for (let row = -6; row <= 6; ++row) {
    for (let column = -8; column <= 8; ++column) {
      const [cx, cy] = [SIDE * Math.sqrt(3) * (column + (Math.abs(row) % 2) / 2), 1.5 * SIDE * row];
      if (!within(cx, cy)) continue;
      for (let sector = 0; sector < 6; ++sector) {
        const [c, s] = [Math.cos((Math.PI / 3) * sector), Math.sin((Math.PI / 3) * sector)];
        const at = (u: number, v: number): string => {
          const [x, y] = [cx + SIDE * (u * c - v * s), cy + SIDE * (u * s + v * c)];
          return seen(x, y, height(x, y));
        };
        for (const [ax, ay, bx, by] of SEGMENTS) path += `M${at(ax, ay)}L${at(bx, by)}`;
      }
    }
  }
  return path;
}

export function ExampleDrawing({ name }: { name: string }) {
  return (
    <svg class="example-drawing" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="xMidYMid meet" aria-hidden="true">
      <path d={fieldPath(SHAPES[name] ?? SHAPES.bridge)} />
    </svg>
  );
}

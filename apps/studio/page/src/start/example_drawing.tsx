// SPDX-License-Identifier: GPL-3.0-or-later
// A small drawing for each example card: a field of hexagons with a simple pattern, bent a little.

const MOTIFS = [
  [[0, 0, 0.5, 0.87], [0, 0, 1, 0], [0.25, 0.43, 0.75, 0.43]],
  [[0.25, 0.43, 0.5, 0], [0.5, 0, 0.75, 0.43], [0, 0, 0.5, 0]],
  [[0, 0, 0.75, 0.43], [0.5, 0, 0.75, 0.43], [0, 0, 0.25, 0.43]],
];
const SIDE = 15;
const [COLUMNS, ROWS] = [9, 4];

function place(index: number, x: number, y: number): string {
  const bend = [Math.sin(x / 62) * 9, Math.cos(x / 50) * 8, -((x - 110) ** 2) / 1300][index % 3];
  return `${(x + 0.35 * y).toFixed(1)} ${(0.62 * y + bend + 22).toFixed(1)}`;
}

function fieldPath(index: number): string {
  const motif = MOTIFS[index % MOTIFS.length];
  let path = '';
  for (let row = 0; row < ROWS; ++row) {
    for (let column = 0; column < COLUMNS; ++column) {
      const [cx, cy] = [18 + SIDE * Math.sqrt(3) * (column + (row % 2) / 2), 18 + 1.5 * SIDE * row];
      for (let sector = 0; sector < 6; ++sector) {
        const turn = (Math.PI / 3) * sector;
        for (const [ax, ay, bx, by] of motif) {
          const at = (x: number, y: number) =>
            place(index, cx + SIDE * 0.95 * (x * Math.cos(turn) - y * Math.sin(turn)), cy + SIDE * 0.95 * (x * Math.sin(turn) + y * Math.cos(turn)));
          path += `M${at(ax, ay)}L${at(bx, by)}`;
        }
      }
    }
  }
  return path;
}

export function ExampleDrawing({ index }: { index: number }) {
  return (
    <svg class="example-drawing" viewBox="0 0 300 100" preserveAspectRatio="xMidYMid slice" aria-hidden="true">
      <path d={fieldPath(index)} />
    </svg>
  );
}

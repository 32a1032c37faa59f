// SPDX-License-Identifier: GPL-3.0-or-later
// The picture of an example's card, as SVG: bars where the answer has them, and the edge at rest.

/** Whole numbers in the picture. */
const [WIDTH, HEIGHT, MARGIN] = [1200, 560, 24];
export const CLASSES = 6;
const COLOURS = ['#4a5a70', '#2f6299', '#1f6f8c', '#157465', '#5a7f2f', '#b98a1c'];
const RADIANS = Math.PI / 180;

/** From where each one is seen: degrees; `stands`: y is up, since it lies in the plane as it was drawn. */
export const VIEWS = {
  shade: { azimuth: 0, elevation: 42 },
  chair_back: { azimuth: -38, elevation: 14, stands: true },
  bridge: { azimuth: -24, elevation: 20 },
  dome: { azimuth: -20, elevation: 16 },
  leaf: { azimuth: -58, elevation: 14 },
  rosette: { azimuth: -20, elevation: 36 },
};

/** Right and up in the picture, and towards the eye. */
function seenFrom({ azimuth, elevation, stands = false }) {
  const [ca, sa, ce, se] = [Math.cos(azimuth * RADIANS), Math.sin(azimuth * RADIANS), Math.cos(elevation * RADIANS), Math.sin(elevation * RADIANS)];
  return ([a, b, c]) => {
    const [x, y, z] = stands ? [a, -c, b] : [a, b, c];
    const depth = ca * y - sa * x;
    return [ca * x + sa * y, ce * z + se * depth, se * z - ce * depth];
  };
}

function fitted(points) {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const zoom = Math.min((WIDTH - 2 * MARGIN) / (right - left), (HEIGHT - 2 * MARGIN) / (high - low));
  const place = ([x, y]) => [Math.round(WIDTH / 2 + zoom * (x - (left + right) / 2)), Math.round(HEIGHT / 2 - zoom * (y - (low + high) / 2))];
  return { place, zoom };
}

const line = ([x, y], [u, v]) => `M${x} ${y}l${u - x} ${v - y}`.replace(/ -/g, '-');

/** Bars by how far they have moved, those at rest first: what moves lies in front of it. */
function classOf(moved, largest) {
  return Math.min(CLASSES - 1, Math.floor((CLASSES * moved) / largest));
}

/**
 * @param answer  {place, displacement: [3 numbers per node].flat(), ends: [2 per bar].flat(), rim: [[node..]..], width: of a bar, m}
 */
export function pictureOf({ place, displacement, ends, rim, width }, view) {
  const seen = seenFrom(view);
  const at = (values, node) => [values[3 * node], values[3 * node + 1], values[3 * node + 2]];
  const count = place.length / 3;
  const moved = Array.from({ length: count }, (_, node) => Math.hypot(...at(displacement, node)));
  const bent = Array.from({ length: count }, (_, node) => seen(at(place, node).map((one, i) => one + at(displacement, node)[i])));
  const rest = rim.map((loop) => loop.map((node) => seen(at(place, node))));
  const fit = fitted([...bent, ...rest.flat()]);
  const largest = Math.max(...moved);
  const groups = Array.from({ length: CLASSES }, () => '');
  for (let bar = 0; bar < ends.length; bar += 2) {
    const [a, b] = [ends[bar], ends[bar + 1]];
    groups[classOf((moved[a] + moved[b]) / 2, largest)] += line(fit.place(bent[a]), fit.place(bent[b]));
  }
  const outline = rest.map((loop) => `M${loop.map((point) => fit.place(point).join(' ')).join('L')}Z`).join('');
  const stroke = Math.max(5, Math.round(fit.zoom * width));
  return [
    '<!-- SPDX-License-Identifier: GPL-3.0-or-later -->',
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" fill="none" stroke-linecap="round">`,
    `<path class="rest" stroke="#999999" stroke-width="3" stroke-dasharray="10 12" d="${outline}"/>`,
    ...groups.map((path, i) => `<path class="d${i}" stroke="${COLOURS[i]}" stroke-width="${stroke}" d="${path}"/>`),
    '</svg>\n',
  ].join('\n');
}

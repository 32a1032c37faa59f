// SPDX-License-Identifier: GPL-3.0-or-later
// The bent surface from the side, over which the wanted shape is drawn.

import { computed, signal } from '@preact/signals';
import { X } from 'lucide-preact';
import { targetOfCurve, type SideAxis, type SideNode } from '../../document/curve';
import { shown } from '../../document/shown';
import { surface } from '../../document/surface';
import { addTarget, displacementOf, followed, target } from '../../document/target';
import { tell } from '../../document/tell';
import { mode, selectedNodes, sideViewOpen } from '../../document/ui';
import type { Point } from '../../protocol/messages';
import { Button, Segments } from '../../widgets/widgets';
import { W } from '../../words';

const [WIDE, HIGH] = [420, 250];
/** How much of the view the surface's length has. */
const FILLED = 0.74;
const STEP_PX = 3;

const axis = signal<SideAxis>(0);
const drawn = signal<readonly Point[] | null>(null);

/** The nodes for which a curve becomes the target: the selected ones, or all. */
const sideNodes = computed<SideNode[]>(() => {
  const places = surface.value?.nodes ?? [];
  const chosen = selectedNodes.value;
  const displacement = shown.value?.solution.displacement ?? null;
  return places.flatMap((place, node) => {
    if (chosen.size > 0 && !chosen.has(node)) return [];
    const moved = displacementOf(displacement, node);
    return [{ node, rest: place[axis.value], now: [place[axis.value] + moved[axis.value], moved[2]] as Point }];
  });
});

/** Metres to pixels of the view; both axes alike. */
const scale = computed(() => {
  const box = surface.value?.box;
  const [low, high] = box ? [box.min[axis.value], box.max[axis.value]] : [0, 1];
  const zoom = (FILLED * WIDE) / (high - low || 1);
  const middle = (low + high) / 2;
  return {
    toView: ([x, z]: Point): Point => [WIDE / 2 + zoom * (x - middle), HIGH / 2 - zoom * z],
    toMetres: ([px, py]: Point): Point => [middle + (px - WIDE / 2) / zoom, (HIGH / 2 - py) / zoom],
  };
});

/** The pointer in the units of the view, which may be drawn smaller. */
function pointOf(event: PointerEvent): Point {
  const matrix = (event.currentTarget as SVGSVGElement).getScreenCTM();
  const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix?.inverse());
  return [x, y];
}

function begin(event: PointerEvent): void {
  (event.currentTarget as Element).setPointerCapture(event.pointerId);
  drawn.value = [pointOf(event)];
}

function follow(event: PointerEvent): void {
  const points = drawn.value;
  if (!points) return;
  const [at, last] = [pointOf(event), points[points.length - 1]];
  if (Math.hypot(at[0] - last[0], at[1] - last[1]) >= STEP_PX) drawn.value = [...points, at];
}

function end(): void {
  const points = drawn.value;
  drawn.value = null;
  if (!points || points.length < 2) return;
  const entry = targetOfCurve(points.map(scale.value.toMetres), sideNodes.value, axis.value);
  if (entry) addTarget(entry);
  else tell(W.side.missed, 'warning');
}

const path = (points: readonly Point[]): string => points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`).join('');

function wantedPoints(): Point[] {
  const places = surface.value?.nodes ?? [];
  const displacement = shown.value?.solution.displacement ?? null;
  return target.value.flatMap(({ nodes, wanted }) =>
    nodes.map((node, i) => {
      const moved = followed(wanted[i], displacementOf(displacement, node));
      return scale.value.toView([places[node][axis.value] + moved[axis.value], moved[2]]);
    }),
  );
}

export function SideView() {
  if (mode.value !== 'design' || !sideViewOpen.value || !surface.value) return null;
  const chosen = selectedNodes.value.size;
  return (
    <section class="card side-view" aria-label={W.side.title}>
      <header role="none">
        <Segments label={W.side.axis} value={axis.value === 0 ? 'x' : 'y'} options={[{ value: 'x', title: W.side.front }, { value: 'y', title: W.side.side }]} onPick={(value) => (axis.value = value === 'x' ? 0 : 1)} />
        <Button kind="bare" title={W.side.close} icon={X} onPress={() => (sideViewOpen.value = false)} />
      </header>
      <svg id="side-view" viewBox={`0 0 ${WIDE} ${HIGH}`} role="img" aria-label={W.side.label} onPointerDown={begin} onPointerMove={follow} onPointerUp={end} onPointerCancel={() => (drawn.value = null)}>
        <line class="level" x1="0" x2={WIDE} y1={HIGH / 2} y2={HIGH / 2} />
        {sideNodes.value.map(({ node, now }) => {
          const [x, y] = scale.value.toView(now);
          return <circle key={node} class="node" cx={x} cy={y} r="2" />;
        })}
        {wantedPoints().map(([x, y], i) => <circle key={i} class="wanted" cx={x} cy={y} r="2.5" />)}
        {drawn.value && <path class="curve" d={path(drawn.value)} />}
      </svg>
      <p class="hint">{chosen ? W.side.hintChosen(chosen) : W.side.hint}</p>
    </section>
  );
}

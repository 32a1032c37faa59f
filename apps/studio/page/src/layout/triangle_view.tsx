// SPDX-License-Identifier: GPL-3.0-or-later
// The base triangle with its candidate edges, and the nodes to drag.

import { useRef } from 'preact/hooks';
import { newGesture } from '../document/edits';
import type { LayoutNode } from '../protocol/requests';
import type { Point } from '../protocol/messages';
import { W } from '../words';
import { addNode, draft, grid, keepsMirror, moveNode, selectedNode } from './draft';
import { CORNERS, HEIGHT, kindAt, placeByKey, SIDE, toPlace, toPlane } from './triangle';

const MARGIN = 9;
const RADIUS = 2.4;
/** Finer grids are not drawn. */
const FINEST_DRAWN = 24;
const LABELS: readonly Point[] = [[SIDE / 2, -4.2], [-3.5, HEIGHT + 3.5], [SIDE + 3.5, HEIGHT + 3.5]];

const line = (points: readonly Point[]): string => points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join('L');

/** Where a pointer is in the drawing. */
function pointAt(svg: SVGSVGElement, event: MouseEvent): Point {
  const seen = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM()?.inverse());
  return [seen.x, seen.y];
}

function Edges() {
  const now = draft.value;
  if (!now) return null;
  const picked = selectedNode.value;
  const pathOf = (edges: readonly [number, number][]): string => edges.map((ends) => `M${line(ends.map((node) => toPlane(now.nodes[node].place)))}`).join('');
  return (
    <>
      <path class="layout-edges" d={pathOf(now.edges)} />
      {picked !== null && <path class="layout-edges picked" d={pathOf(now.edges.filter((ends) => ends.includes(picked)))} />}
    </>
  );
}

function GridDots() {
  const steps = grid.value;
  if (steps > FINEST_DRAWN) return null;
  let path = '';
  for (let i = 0; i <= steps; ++i) for (let j = 0; i + j <= steps; ++j) path += `M${line([toPlane([1 - (i + j) / steps, i / steps, j / steps])])}h0`;
  return <path class="layout-grid" d={path} />;
}

interface NodeProps {
  index: number;
  node: LayoutNode;
  onDrag: (index: number, event: PointerEvent) => void;
}
/** Whether a node moves when the selected one is moved. */
function goesAlong(index: number, { kind }: LayoutNode): boolean {
  const selected = selectedNode.value === null ? null : draft.value?.nodes[selectedNode.value];
  return (selected?.twins.includes(index) ?? false) && (kind !== 'face' || keepsMirror.value);
}

function NodeMark({ index, node, onDrag }: NodeProps) {
  const gesture = useRef('');
  const [x, y] = toPlane(node.place);
  const isSelected = selectedNode.value === index;
  const isTwin = goesAlong(index, node);
  const keys = (event: KeyboardEvent) => {
    if (!event.key.startsWith('Arrow')) return;
    event.preventDefault();
    if (!event.repeat) gesture.current = newGesture('node');
    const to = placeByKey(node, event.key, grid.peek());
    if (to) moveNode(index, to, gesture.current);
  };
  return (
    <g class={`layout-node ${node.kind}${isSelected ? ' selected' : ''}${isTwin ? ' twin' : ''}`} data-node={index} tabIndex={0} role="button" aria-pressed={isSelected}
      aria-label={W.layouts.node(index, W.layouts.kinds[node.kind], node.exact.join(', '))} transform={`translate(${x.toFixed(3)} ${y.toFixed(3)})`}
      onPointerDown={(event) => onDrag(index, event)} onFocus={() => (selectedNode.value = index)} onKeyDown={keys}>
      <circle class="layout-reach" r={2 * RADIUS} />
      <circle r={RADIUS} />
      <text y={0.9}>{index}</text>
    </g>
  );
}

export function TriangleView() {
  const svg = useRef<SVGSVGElement>(null);
  const drag = useRef<{ node: number; pointer: number; gesture: string } | null>(null);
  const begin = (node: number, event: PointerEvent) => {
    if (event.button !== 0 || drag.current) return;
    event.stopPropagation();
    svg.current?.setPointerCapture(event.pointerId);
    drag.current = { node, pointer: event.pointerId, gesture: newGesture('node') };
    selectedNode.value = node;
  };
  const move = (event: PointerEvent) => {
    const now = drag.current;
    if (now?.pointer === event.pointerId) moveNode(now.node, toPlace(pointAt(svg.current as SVGSVGElement, event)), now.gesture);
  };
  const end = (event: PointerEvent) => {
    if (drag.current?.pointer === event.pointerId) drag.current = null;
  };
  const add = (event: MouseEvent) => {
    if ((event.target as Element).closest('.layout-node')) return;
    const place = toPlace(pointAt(svg.current as SVGSVGElement, event));
    void addNode(kindAt(place), place);
  };
  return (
    <svg ref={svg} id="triangle" class="layout-triangle" role="group" aria-label={W.layouts.triangle} viewBox={`${-MARGIN} ${-MARGIN} ${SIDE + 2 * MARGIN} ${HEIGHT + 2 * MARGIN}`}
      onPointerMove={move} onPointerUp={end} onPointerCancel={end} onDblClick={add}>
      <path class="layout-ground" d={`M${line(CORNERS)}Z`} />
      <GridDots />
      <Edges />
      <path class="layout-side" d={`M${line(CORNERS.slice(1))}`} />
      {W.layouts.corner.map((name, i) => <text key={name} class="layout-corner" x={LABELS[i][0]} y={LABELS[i][1]}>{name}</text>)}
      {draft.value?.nodes.map((node, index) => <NodeMark key={index} index={index} node={node} onDrag={begin} />)}
    </svg>
  );
}

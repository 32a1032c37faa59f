// SPDX-License-Identifier: GPL-3.0-or-later
// The plane and the space beside or above each other, whichever shows the surface larger.

import { useEffect, useRef, useState } from 'preact/hooks';
import { surface } from '../document/surface';
import { share, split } from '../document/ui';
import { PlaneView } from './plane/plane';
import { SpaceView } from './space/space';
import { W } from '../words';

const [LEAST, MOST] = [0.2, 0.8];
const within = (value: number): number => Math.min(MOST, Math.max(LEAST, value));

function stacks({ width, height }: { width: number; height: number }): boolean {
  const box = surface.value?.box;
  if (!box) return false;
  const [w, h] = [box.max[0] - box.min[0], box.max[1] - box.min[1]];
  return Math.min(width / w, height / 2 / h) > Math.min(width / 2 / w, height / h);
}

export function Views() {
  const host = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState({ width: 1000, height: 700 });
  useEffect(() => {
    const element = host.current as HTMLDivElement;
    const resized = new ResizeObserver(() => setSize({ width: element.clientWidth, height: element.clientHeight }));
    resized.observe(element);
    return () => resized.disconnect();
  }, []);
  const stacked = stacks(size);
  const both = split.value === 'both';
  const tracks = both ? `minmax(0, ${1 - share.value}fr) 7px minmax(0, ${share.value}fr)` : '100%';
  const drag = (event: PointerEvent) => {
    const box = host.current?.getBoundingClientRect();
    if (!box || !event.buttons) return;
    share.value = within(stacked ? (box.bottom - event.clientY) / box.height : (box.right - event.clientX) / box.width);
  };
  const keys = (event: KeyboardEvent) => {
    const step = { ArrowLeft: 0.03, ArrowUp: 0.03, ArrowRight: -0.03, ArrowDown: -0.03 }[event.key];
    if (step) share.value = within(share.value + step);
  };
  return (
    <div class={`views ${stacked ? 'stacked' : ''}`} ref={host}
      style={stacked ? { gridTemplateRows: tracks, gridTemplateColumns: '100%' } : { gridTemplateColumns: tracks, gridTemplateRows: '100%' }}>
      {split.value !== 'plane' && <SpaceView />}
      {both && (
        <div class="divider" role="separator" aria-orientation={stacked ? 'horizontal' : 'vertical'} aria-label={W.views.betweenDAndD} aria-valuenow={Math.round(100 * share.value)}
          tabIndex={0} onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)} onPointerMove={drag} onDblClick={() => (share.value = 0.44)} onKeyDown={keys} />
      )}
      {split.value !== 'space' && <PlaneView />}
    </div>
  );
}

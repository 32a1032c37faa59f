// SPDX-License-Identifier: GPL-3.0-or-later

import { useEffect, useRef } from 'preact/hooks';
import { effect } from '@preact/signals';
import { probed } from '../../document/ui';
import { shown } from '../../document/shown';
import { NextStep } from '../../panels/next_step';
import { LegendCard } from './legend';
import { ProbeCard } from './probe';
import { SideView } from './side_view';
import { SceneView } from './scene_view';
import { attachPointer } from './pointer';
import { onScreen, probedPlace } from './placed';
import { currentScene } from './current';
import { ViewBar } from './view_bar';
import { PlayBar } from './play_bar';
import { W } from '../../words';
import './space.css';

export function SpaceView() {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const pin = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    const view = new SceneView(element);
    currentScene.value = view;
    const box = host.current as HTMLDivElement;
    const resized = new ResizeObserver(() => view.stage.resize(box.clientWidth, box.clientHeight));
    resized.observe(box);
    const detach = attachPointer(element, view);
    element.addEventListener('keydown', (event) => turnByKey(event, view));
    const place = () => placePin(pin.current, view, box);
    view.stage.beforeDraw(place);
    const stop = effect(() => {
      void [probed.value, shown.value];
      place();
    });
    return () => {
      stop();
      detach();
      resized.disconnect();
      view.dispose();
      currentScene.value = null;
    };
  }, []);
  return (
    <div class="space" ref={host}>
      <canvas ref={canvas} aria-label={W.space.dViewDragTo} tabIndex={0} />
      <div class="pin" ref={pin} hidden><ProbeCard /></div>
      <NextStep />
      <LegendCard />
      <SideView />
      <div class="space-foot">
        <PlayBar />
        <ViewBar />
      </div>
    </div>
  );
}

const KEY_TURN = Math.PI / 18;
const TURNS: Record<string, [number, number]> = { ArrowLeft: [-KEY_TURN, 0], ArrowRight: [KEY_TURN, 0], ArrowUp: [0, KEY_TURN], ArrowDown: [0, -KEY_TURN] };
const KEY_ZOOM: Record<string, number> = { '+': 1.15, '=': 1.15, '-': 1 / 1.15 };

/** Arrows turn the view, plus and minus go nearer and farther. */
function turnByKey(event: KeyboardEvent, { stage }: SceneView): void {
  const turn = TURNS[event.key];
  const zoom = KEY_ZOOM[event.key];
  if ((!turn && !zoom) || event.ctrlKey || event.metaKey) return;
  event.preventDefault();
  event.stopPropagation();
  if (turn) stage.turn(...turn);
  else stage.approach(zoom);
}

/** The room that the text beside it needs. */
const CARD_PX = { node: 250, beam: 430 };

function placePin(pin: HTMLDivElement | null, view: SceneView, box: HTMLElement): void {
  if (!pin) return;
  const at = probed.peek();
  const seen = at && onScreen(probedPlace(at), view.stage.camera, { width: box.clientWidth, height: box.clientHeight });
  pin.hidden = !seen;
  if (!seen) return;
  const left = seen[0] > box.clientWidth - CARD_PX[at.kind];
  pin.style.transform = `translate(${seen[0]}px, ${seen[1]}px) translate(${left ? 'calc(-100% - 16px)' : '16px'}, -50%)`;
}

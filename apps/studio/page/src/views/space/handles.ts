// SPDX-License-Identifier: GPL-3.0-or-later
// The ends of arrows, and the diamonds of prescribed displacements, follow the pointer.

import { Plane, Ray, Raycaster, Vector2, Vector3, type Camera } from 'three';
import { dragLoad, dragPrescribed, newGesture } from '../../document/edits';
import { markInput } from '../../document/latency';
import { scale as drawnScale } from '../../document/look';
import { loadMarks, prescribedMarks, type LoadMark, type PrescribedMark } from '../../document/marks';
import { movedBy, replaceTarget, target } from '../../document/target';
import { activeEntry, mode } from '../../document/ui';
import type { Load, Vector } from '../../protocol/messages';
import { pushes, reachOf, takenAs, type ArrowScale } from './marks_view';
import { middle, onScreen } from './placed';
import { snapped } from './snap';
import { entryPlace } from './target_view';

interface View {
  camera: Camera;
  size: { width: number; height: number };
}
interface Pointer {
  at: [number, number];
  free: boolean;
  when: number;
}
export interface Drag {
  move(pointer: Pointer): void;
  end(): void;
}

const REACH_PX = 18;
/** For a finger. */
export const TOUCH_REACH_PX = 32;
const AXES = { ux: new Vector3(1, 0, 0), uy: new Vector3(0, 1, 0), uz: new Vector3(0, 0, 1) };

function rayAt(at: [number, number], { camera, size }: View): Ray {
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * at[0]) / size.width - 1, 1 - (2 * at[1]) / size.height), camera);
  return caster.ray;
}

const near = (place: Vector3, at: [number, number], view: View, reach: number): boolean => {
  const seen = onScreen(place, view.camera, view.size);
  return seen !== null && Math.hypot(seen[0] - at[0], seen[1] - at[1]) < reach;
};

interface Handle {
  place: Vector3;
  take(at: [number, number], view: View): Drag;
}

/** All that can be taken: tips of arrows, and diamonds; while one designs, those of the target. */
export function handles(arrows: ArrowScale): Handle[] {
  if (mode.peek() === 'design')
    return target.peek().map((entry, index) => ({ place: entryPlace(entry), take: (at: [number, number], view: View) => dragTarget(index, at, view) }));
  const tips = loadMarks.peek().flatMap((mark) =>
    (['force', 'moment'] as const).flatMap((key) => {
      if (Math.hypot(...mark[key]) === 0) return [];
      const place = middle(mark.nodes).add(reachOf(mark[key], arrows[key]));
      return [{ place, take: (_: [number, number], view: View) => dragArrow(mark, key, { view, arrows, tip: place }) }];
    }),
  );
  const diamonds = prescribedMarks
    .peek()
    .filter((mark) => mark.dof in AXES)
    .map((mark) => ({ place: middle(mark.nodes), take: (at: [number, number], view: View) => dragDiamond(mark, at, view) }));
  return [...tips, ...diamonds];
}

/** The handle under the pointer; undefined where there is none. */
export const handleAt = (at: [number, number], view: View, { arrows, reach = REACH_PX }: { arrows: ArrowScale; reach?: number }): Handle | undefined =>
  handles(arrows).find(({ place }) => near(place, at, view, reach));

function dragArrow(mark: LoadMark, key: 'force' | 'moment', { view, arrows, tip }: { view: View; arrows: ArrowScale; tip: Vector3 }): Drag {
  const merge = newGesture('load');
  const base = middle(mark.nodes);
  const facing = view.camera.getWorldDirection(new Vector3());
  const plane = new Plane().setFromNormalAndCoplanarPoint(facing, tip);
  let last = mark.load;
  takenAs.pushes = pushes(mark[key]);
  const perMetre = (takenAs.pushes ? -1 : 1) / arrows[key];
  activeEntry.value = { kind: 'load', index: mark.index };
  return {
    move({ at, free, when }) {
      const target = rayAt(at, view).intersectPlane(plane, new Vector3());
      if (!target) return;
      const vector = target.sub(base).multiplyScalar(perMetre).toArray() as Vector;
      last = { ...last, ...written(mark, key, free ? vector : snapped(vector)) };
      markInput(when);
      dragLoad(mark.index, last, merge);
    },
    end: () => void (takenAs.pushes = null),
  };
}

/** The part of a load that says how large it is. */
function written({ load, extent }: LoadMark, key: 'force' | 'moment', vector: Vector): Partial<Load> {
  if (!extent) return { [key]: vector };
  return { [load.per_length ? 'per_length' : 'per_area']: vector.map((value) => value / extent) as Vector };
}

/** Drags a target up and down; with Shift, in the plane of the picture. */
function dragTarget(index: number, start: [number, number], view: View): Drag {
  const entry = target.peek()[index];
  const origin = entryPlace(entry);
  const facing = view.camera.getWorldDirection(new Vector3());
  const level = new Vector3(facing.x, facing.y, 0);
  const factor = drawnScale.peek() || 1;
  const along = (at: [number, number], free: boolean): Vector3 => {
    const upright = !free && level.lengthSq() > 1e-6;
    const plane = new Plane().setFromNormalAndCoplanarPoint(upright ? level.clone().normalize() : facing, origin);
    const met = rayAt(at, view).intersectPlane(plane, new Vector3());
    const by = met ? met.sub(origin) : new Vector3();
    return free ? by : by.set(0, 0, by.z);
  };
  activeEntry.value = { kind: 'target', index };
  return {
    move({ at, free }) {
      const by = along(at, free).sub(along(start, free)).divideScalar(factor);
      replaceTarget(index, movedBy(entry, by.toArray() as Vector));
    },
    end: () => undefined,
  };
}

function dragDiamond(mark: PrescribedMark, start: [number, number], view: View): Drag {
  const merge = newGesture('prescribed');
  const axis = AXES[mark.dof as keyof typeof AXES];
  const origin = middle(mark.nodes);
  const along = (at: [number, number]): number => {
    const ray = rayAt(at, view);
    const onLine = new Vector3();
    const far = 100;
    ray.distanceSqToSegment(origin.clone().addScaledVector(axis, -far), origin.clone().addScaledVector(axis, far), undefined, onLine);
    return onLine.sub(origin).dot(axis);
  };
  const begin = along(start);
  const factor = drawnScale.peek() || 1;
  let last = mark.entry;
  activeEntry.value = { kind: 'prescribed', index: mark.index };
  return {
    move({ at, when }) {
      last = { ...mark.entry, [mark.dof]: mark.value + (along(at) - begin) / factor };
      markInput(when);
      dragPrescribed(mark.index, last, merge);
    },
    end: () => undefined,
  };
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Two cameras that look at one place: in perspective, or parallel, in which lengths across the view can be compared.

import { Box3, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';

export type Projection = 'perspective' | 'parallel';

const FIELD_OF_VIEW = 32;
const SLOPE = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);

/** Where a camera is put. `distance` and `halfHeight` (m) belong to the two kinds of camera. */
export interface Placing {
  center: Vector3;
  /** From the centre to the eye, of length one. */
  direction: Vector3;
  distance: number;
  /** Of the picture, at the centre. */
  halfHeight: number;
}

export class Cameras {
  private readonly perspective = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.001, 100);
  private readonly parallel = new OrthographicCamera(-1, 1, 1, -1, -100, 100);
  projection: Projection = 'perspective';
  private ratio = 1;

  constructor() {
    for (const camera of [this.perspective, this.parallel]) camera.up.set(0, 0, 1);
  }

  get now(): PerspectiveCamera | OrthographicCamera {
    return this.projection === 'perspective' ? this.perspective : this.parallel;
  }

  set aspect(ratio: number) {
    this.ratio = ratio;
    this.perspective.aspect = ratio;
    this.setHalfHeight(this.parallel.top);
    this.perspective.updateProjectionMatrix();
  }

  private setHalfHeight(halfHeight: number): void {
    Object.assign(this.parallel, { top: halfHeight, bottom: -halfHeight, right: this.ratio * halfHeight, left: -this.ratio * halfHeight });
    this.parallel.updateProjectionMatrix();
  }

  /** Half of the picture's height in metres, at a place that is looked at. */
  halfHeightAt(target: Vector3): number {
    return this.projection === 'parallel' ? this.parallel.top / this.parallel.zoom : SLOPE * this.perspective.position.distanceTo(target);
  }

  place({ center, direction, distance, halfHeight }: Placing): void {
    for (const camera of [this.perspective, this.parallel]) camera.position.copy(center).addScaledVector(direction, distance);
    this.perspective.near = distance / 200;
    this.perspective.far = distance * 20;
    this.perspective.updateProjectionMatrix();
    this.parallel.zoom = 1;
    this.parallel.near = -20 * distance;
    this.parallel.far = 20 * distance;
    this.setHalfHeight(halfHeight);
  }

  /** The other camera, which sees the target as large as this one. */
  switchTo(projection: Projection, target: Vector3): PerspectiveCamera | OrthographicCamera {
    const before = this.now;
    const halfHeight = this.halfHeightAt(target);
    const direction = before.position.clone().sub(target).normalize();
    this.projection = projection;
    this.place({ center: target, direction, distance: halfHeight / SLOPE, halfHeight });
    this.now.quaternion.copy(before.quaternion);
    return this.now;
  }

  /**
   * Where to look, and how far away (or how large) the picture must be, so that all places are seen with the
   * present direction of the camera. `usable`: the share of the height that nothing covers.
   */
  seeing(places: readonly Vector3[], usable: number): { center: Vector3; distance: number; halfHeight: number } {
    const turn = this.now.quaternion.clone().invert();
    const seen = places.map((place) => place.clone().applyQuaternion(turn));
    const center = new Box3().setFromPoints(seen).getCenter(new Vector3());
    let [distance, halfHeight] = [1e-3, 1e-4];
    for (const at of seen) {
      const needed = Math.max(Math.abs(at.y - center.y) / usable, Math.abs(at.x - center.x) / this.ratio);
      halfHeight = Math.max(halfHeight, needed);
      distance = Math.max(distance, at.z - center.z + needed / SLOPE);
    }
    if (this.projection === 'parallel') distance = halfHeight / SLOPE;
    return { center: center.applyQuaternion(this.now.quaternion), distance, halfHeight };
  }
}

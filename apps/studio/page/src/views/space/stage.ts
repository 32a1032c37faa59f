// SPDX-License-Identifier: GPL-3.0-or-later
// Camera and picture. Drawn when something changed, not all the time; and once it rests, finer and finer.

import { BasicShadowMap, Box3, Color, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { Accumulator } from './accumulator';
import { Lights, spread } from './lights';
import { drawsInSoftware } from './software';

export type ViewName = 'iso' | 'top' | 'front' | 'side';
const FRAME_MARGIN = 1.12;
/** What the bar at the bottom covers. */
const BAR_PX = 56;
/** How long nothing must have changed before the picture becomes finer. */
const REST_MS = 300;
const FEWEST_SAMPLES = 3;
const MOST_SAMPLES = drawsInSoftware ? 14 : 64;
const POLL_MS = 8;
const DIRECTIONS: Record<ViewName, [number, number, number]> = { iso: [-0.45, -1, 0.62], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, -0.02, 0.02] };

/** At once, or as good as it gets. */
export type Quality = 'quick' | 'fine';

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(32, 1, 0.001, 100);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  private readonly lights = new Lights(this.scene);
  private fine: Accumulator | null = null;
  private asked = 0;
  private rest = 0;
  private size = { width: 1, height: 1 };
  private usable = 1;
  /** For tests on machines that draw in software: everything but the drawing. */
  private readonly paused = window.fretworkPaused === true;
  private framing: { box: Box3; from: ViewName | null } | null = null;
  private readonly before = new Set<(quality: Quality) => void>();

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !drawsInSoftware, alpha: true, powerPreference: 'high-performance' });
    this.renderer.setClearColor(new Color(0), 0);
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = drawsInSoftware ? BasicShadowMap : PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => (this.framing = null));
    this.controls.zoomToCursor = true;
  }

  /** Called right before each picture. */
  beforeDraw(action: (quality: Quality) => void): void {
    this.before.add(action);
  }

  draw(): void {
    this.stopRefining();
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.drawNow();
    });
  }

  drawNow(): void {
    this.stopRefining();
    if (this.paused) return;
    this.drawOnce();
    this.rest = window.setTimeout(() => this.refine(), REST_MS);
  }

  drawOnce(): void {
    this.prepare('quick');
    this.lights.quick(!drawsInSoftware);
    this.renderer.render(this.scene, this.camera);
  }

  /** As fine as it gets, at once. */
  drawFinest(): void {
    this.beginFine();
    while (this.fine && this.fine.count < MOST_SAMPLES) this.sample(this.fine);
    this.fine?.present();
  }

  private stopRefining(): void {
    clearTimeout(this.rest);
    this.rest = 0;
  }

  private prepare(quality: Quality): void {
    for (const action of this.before) action(quality);
  }

  private beginFine(): Accumulator {
    this.prepare('fine');
    this.fine ??= new Accumulator(this.renderer);
    this.fine.restart();
    return this.fine;
  }

  /** One sample after the other, the next when the last is drawn: whoever touches something waits for one at most. */
  private refine(): void {
    const fine = this.beginFine();
    const later = (action: () => void, pause: number) => (this.rest = window.setTimeout(action, pause));
    const step = () => {
      const began = performance.now();
      this.sample(fine);
      const isDrawn = this.fence();
      const wait = () => {
        if (!isDrawn()) return later(wait, POLL_MS);
        if (fine.count >= FEWEST_SAMPLES) fine.present();
        return fine.count < MOST_SAMPLES && later(step, drawsInSoftware ? performance.now() - began : 0);
      };
      later(wait, 0);
    };
    step();
  }

  /** Tells whether the graphics card has done what it was told before. */
  private fence(): () => boolean {
    const context = this.renderer.getContext() as WebGL2RenderingContext;
    const sync = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
    context.flush();
    return () => !sync || context.getSyncParameter(sync, context.SYNC_STATUS) === context.SIGNALED;
  }

  private sample(fine: Accumulator): void {
    const { width, height } = this.size;
    const [x, y] = spread(fine.count);
    this.camera.setViewOffset(width, height, x - 0.5, BAR_PX / 2 + y - 0.5, width, height);
    this.lights.sample(fine.count);
    fine.take(this.scene, this.camera);
    this.camera.setViewOffset(width, height, 0, BAR_PX / 2, width, height);
  }

  resize(width: number, height: number): void {
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.size = { width, height };
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, 0, BAR_PX / 2, width, height);
    this.usable = Math.max(0.3, (height - BAR_PX) / height);
    this.camera.updateProjectionMatrix();
    if (this.framing) this.look(this.framing.box, this.framing.from);
    this.drawNow();
  }

  set shadows(on: boolean) {
    this.lights.shadows = on;
    this.draw();
  }

  /** Light and floor for a surface within a box. */
  light(box: Box3): void {
    this.lights.fit(box);
  }

  dispose(): void {
    this.stopRefining();
    cancelAnimationFrame(this.asked);
    this.controls.dispose();
    this.fine?.dispose();
    this.renderer.dispose();
  }

  /** Look at a box from a named side, so that all of it is seen. */
  look(box: Box3, from: ViewName | null): void {
    this.framing = { box, from };
    const center = box.getCenter(new Vector3());
    const direction = from ? new Vector3(...DIRECTIONS[from]) : this.camera.position.clone().sub(this.controls.target);
    this.controls.target.copy(center);
    this.camera.position.copy(center).add(direction.normalize());
    this.camera.lookAt(center);
    const distance = FRAME_MARGIN * this.distanceFor(box, center);
    this.camera.position.copy(center).addScaledVector(direction, distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** How far from its middle the camera must be to see all corners of a box, from where it looks now. */
  private distanceFor(box: Box3, center: Vector3): number {
    const upward = this.usable * Math.tan((this.camera.fov * Math.PI) / 360);
    const sideward = (upward / this.usable) * this.camera.aspect;
    const turn = this.camera.quaternion.clone().invert();
    let distance = 1e-3;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z);
      at.sub(center).applyQuaternion(turn);
      distance = Math.max(distance, at.z + Math.abs(at.y) / upward, at.z + Math.abs(at.x) / sideward);
    }
    return distance;
  }

  /** Whether nobody has turned the view since it was set. */
  get untouched(): boolean {
    return this.framing !== null;
  }

  /** The picture as a file, twice as fine as on the screen, on transparent ground. */
  async picture(): Promise<Blob> {
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(2 * ratio);
    this.stopRefining();
    this.drawFinest();
    const blob = await new Promise<Blob | null>((done) => this.renderer.domElement.toBlob(done, 'image/png'));
    this.renderer.setPixelRatio(ratio);
    this.drawNow();
    if (!blob) throw new Error('The picture could not be made.');
    return blob;
  }
}

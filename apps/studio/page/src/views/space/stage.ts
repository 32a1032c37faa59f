// SPDX-License-Identifier: GPL-3.0-or-later
// Camera and picture. Drawn when something changed, not all the time; and once it rests, finer and finer.

import { BasicShadowMap, Box3, Color, NeutralToneMapping, PCFShadowMap, Scene, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { Accumulator } from './accumulator';
import { Cameras, type Projection } from './cameras';
import { Lights, spread } from './lights';
import { drawsInSoftware } from './software';
import { W } from '../../words';

export type ViewName = 'iso' | 'top' | 'front' | 'side';
const FRAME_MARGIN = 1.1;
/** Covered by the bar at the bottom. */
const BAR_PX = 56;
/** How long nothing must have changed before the picture becomes finer. */
const REST_MS = drawsInSoftware ? 1000 : 300;
const FEWEST_SAMPLES = 3;
const MOST_SAMPLES = drawsInSoftware ? 14 : 64;
const PICTURE_SAMPLES = drawsInSoftware ? 6 : MOST_SAMPLES;
const POLL_MS = 8;
/** A machine that needs longer keeps the quick picture. */
const LONGEST_SAMPLE_MS = 4000;
const DIRECTIONS: Record<ViewName, [number, number, number]> = { iso: [-0.45, -1, 0.62], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, -0.02, 0.02] };

export interface Framing {
  places: readonly Vector3[];
  /** null: from where it is seen now. */
  from: ViewName | null;
}

/** At once, or as good as it gets. */
export type Quality = 'quick' | 'fine';

export class Stage {
  readonly scene = new Scene();
  private readonly cameras = new Cameras();
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  private readonly lights = new Lights(this.scene);
  private fine: Accumulator | null = null;
  private asked = 0;
  /** Whether the last picture is there: a slow machine is given one at a time. */
  private isDrawn = () => true;
  private rest = 0;
  private size = { width: 1, height: 1 };
  private usable = 1;
  /** Draws nothing by itself, for tests on machines that draw in software. */
  private readonly paused = window.fretworkPaused === true;
  private framing: Framing | null = null;
  private readonly before = new Set<(quality: Quality) => void>();
  private readonly after = new Set<() => void>();

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !drawsInSoftware, alpha: true, powerPreference: 'high-performance' });
    this.renderer.setClearColor(new Color(0), 0);
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = drawsInSoftware ? BasicShadowMap : PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => (this.framing = null));
    this.controls.zoomToCursor = true;
  }

  /** Called right before each picture. */
  beforeDraw(action: (quality: Quality) => void): void {
    this.before.add(action);
  }

  /** Called right after each quick picture, while it can be read. Returns a function that ends this. */
  afterDraw(action: () => void): () => void {
    this.after.add(action);
    return () => this.after.delete(action);
  }

  get camera(): Cameras['now'] {
    return this.cameras.now;
  }
  get projection(): Projection {
    return this.cameras.projection;
  }
  /** Metres across the view for a pixel of the page; null in perspective, where they differ. */
  get metresPerPixel(): number | null {
    return this.projection === 'perspective' ? null : (2 * this.cameras.halfHeightAt(this.controls.target)) / this.size.height;
  }
  /** What is seen stays as large as it is, at the place that the camera looks at. */
  set projection(projection: Projection) {
    if (projection === this.cameras.projection) return;
    this.controls.object = this.cameras.switchTo(projection, this.controls.target);
    this.setOffset();
    this.controls.update();
    this.draw();
  }

  draw(): void {
    this.stopRefining();
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      if (this.isDrawn()) this.drawNow();
      else this.draw();
    });
  }

  drawNow(): void {
    this.stopRefining();
    if (this.paused) return;
    this.drawOnce();
    this.isDrawn = this.fence();
    this.rest = window.setTimeout(() => this.refine(), REST_MS);
  }

  /** Draws at once, in the place of a picture that was asked for. */
  drawOnce(): void {
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    this.prepare('quick');
    this.lights.quick(!drawsInSoftware);
    this.renderer.render(this.scene, this.camera);
    for (const action of this.after) action();
  }

  /** Draws with this many samples, at once. */
  drawFine(samples = MOST_SAMPLES): void {
    this.stopRefining();
    const fine = this.beginFine();
    while (fine.count < samples) this.sample(fine);
    fine.present();
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
      this.isDrawn = this.fence();
      const wait = () => {
        if (!this.isDrawn()) return later(wait, POLL_MS);
        if (fine.count >= FEWEST_SAMPLES) fine.present();
        const took = performance.now() - began;
        return fine.count < MOST_SAMPLES && took < LONGEST_SAMPLE_MS && later(step, drawsInSoftware ? took : 0);
      };
      later(wait, 0);
    };
    step();
  }

  /** Returns a check that the graphics card has finished the commands so far. */
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
    this.setOffset();
  }

  /** The middle of the picture lies above the bar at the bottom. */
  private setOffset(): void {
    const { width, height } = this.size;
    this.camera.setViewOffset(width, height, 0, BAR_PX / 2, width, height);
  }

  resize(width: number, height: number): void {
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.size = { width, height };
    this.cameras.aspect = width / height;
    this.setOffset();
    this.usable = Math.max(0.3, (height - BAR_PX) / height);
    if (this.framing) this.look(this.framing);
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

  /** Look at some places from a named side, so that all of them are seen. */
  look(framing: Framing): void {
    this.framing = framing;
    const { places, from } = framing;
    const direction = from ? new Vector3(...DIRECTIONS[from]) : this.camera.position.clone().sub(this.controls.target);
    this.camera.position.copy(direction.normalize());
    this.camera.lookAt(0, 0, 0);
    const { center, distance, halfHeight } = this.cameras.seeing(places, this.usable);
    this.controls.target.copy(center);
    this.cameras.place({ center, direction, distance: FRAME_MARGIN * distance, halfHeight: FRAME_MARGIN * halfHeight });
    this.setOffset();
    this.controls.update();
    this.draw();
  }

  /** Turn around what is looked at, in radians: to the side, and up. */
  turn(sideward: number, upward: number): void {
    this.framing = null;
    this.controls.rotateLeft(-sideward);
    this.controls.rotateUp(upward);
  }

  /** Nearer by this factor, or farther. */
  approach(factor: number): void {
    this.framing = null;
    this.controls.dollyIn(1 / factor);
  }

  /** Whether nobody has turned the view since it was set. */
  get untouched(): boolean {
    return this.framing !== null;
  }

  /** The picture as a file, twice as fine as on the screen, on transparent ground. */
  async picture(): Promise<Blob> {
    const ratio = this.renderer.getPixelRatio();
    this.renderer.setPixelRatio(2 * ratio);
    this.drawFine(PICTURE_SAMPLES);
    const blob = await new Promise<Blob | null>((done) => this.renderer.domElement.toBlob(done, 'image/png'));
    this.renderer.setPixelRatio(ratio);
    this.drawNow();
    if (!blob) throw new Error(W.stage.thePictureCouldNot);
    return blob;
  }
}

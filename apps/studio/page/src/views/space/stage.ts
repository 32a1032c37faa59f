// SPDX-License-Identifier: GPL-3.0-or-later
// Camera, lights and the picture itself. Drawn when something changed, not all the time.

import {
  Box3, Color, DirectionalLight, HemisphereLight, Mesh, PCFShadowMap, PerspectiveCamera, PlaneGeometry, Scene, ShadowMaterial, Vector3,
  WebGLRenderer, ACESFilmicToneMapping, NeutralToneMapping,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { drawsInSoftware } from './software';

export type ViewName = 'iso' | 'top' | 'front' | 'side';
const FRAME_MARGIN = 1.12;
/** What the bar at the bottom covers. */
const BAR_PX = 56;
const DIRECTIONS: Record<ViewName, [number, number, number]> = { iso: [-0.45, -1, 0.62], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, -0.02, 0.02] };

export class Stage {
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(32, 1, 0.001, 100);
  readonly renderer: WebGLRenderer;
  readonly controls: OrbitControls;
  private readonly sun = new DirectionalLight('#fff4e2', 2.9);
  private readonly floor = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: 0.16 }));
  private asked = 0;
  private usable = 1;
  /** For tests on machines that draw in software: everything but the drawing. */
  private readonly paused = window.fretworkPaused === true;
  private framing: { box: Box3; from: ViewName | null } | null = null;
  private readonly before = new Set<() => void>();

  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !drawsInSoftware, alpha: true, powerPreference: 'high-performance' });
    this.renderer.setClearColor(new Color(0), 0);
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = NeutralToneMapping ?? ACESFilmicToneMapping;
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => (this.framing = null));
    this.controls.zoomToCursor = true;
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.radius = 5;
    this.floor.receiveShadow = true;
    this.scene.add(new HemisphereLight('#ffffff', '#a79f92', 1.9), this.sun, this.sun.target, this.floor);
    const fill = new DirectionalLight('#dfe9ff', 0.7);
    fill.position.set(-2, 1.5, 1);
    this.scene.add(fill);
  }

  /** Called right before each picture. */
  beforeDraw(action: () => void): void {
    this.before.add(action);
  }

  draw(): void {
    if (this.asked) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.drawNow();
    });
  }

  drawNow(): void {
    if (!this.paused) this.drawOnce();
  }

  drawOnce(): void {
    for (const action of this.before) action();
    this.renderer.render(this.scene, this.camera);
  }

  resize(width: number, height: number): void {
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.setViewOffset(width, height, 0, BAR_PX / 2, width, height);
    this.usable = Math.max(0.3, (height - BAR_PX) / height);
    this.camera.updateProjectionMatrix();
    if (this.framing) this.look(this.framing.box, this.framing.from);
    this.drawNow();
  }

  set shadows(on: boolean) {
    this.sun.castShadow = on;
    this.floor.visible = on;
    this.draw();
  }

  /** Light and floor for a surface within a box. */
  light(box: Box3): void {
    const center = box.getCenter(new Vector3());
    const reach = box.getSize(new Vector3()).length() * 0.75 || 1;
    this.sun.position.copy(center).add(new Vector3(-0.55, -0.35, 1.25).multiplyScalar(2 * reach));
    this.sun.target.position.copy(center);
    const shadow = this.sun.shadow.camera;
    shadow.left = shadow.bottom = -reach;
    shadow.right = shadow.top = reach;
    shadow.near = 0.2 * reach;
    shadow.far = 6 * reach;
    shadow.updateProjectionMatrix();
    this.sun.shadow.normalBias = 0.0012 * reach;
    this.sun.shadow.bias = -0.0006;
    this.floor.scale.setScalar(8 * reach);
    this.floor.position.set(center.x, center.y, Math.min(box.min.z, 0) - 0.04 * reach);
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
    this.drawNow();
    const blob = await new Promise<Blob | null>((done) => this.renderer.domElement.toBlob(done, 'image/png'));
    this.renderer.setPixelRatio(ratio);
    this.drawNow();
    if (!blob) throw new Error('The picture could not be made.');
    return blob;
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
// The sun with its shadow, the sky, and the floor that catches the shadow. For a quick picture the sky casts no shadow; for a fine
// one, many pictures are averaged, each with the sun a little elsewhere and the whole sky shining from one place: soft shadows, and
// less light where the sky is hidden.

import { Box3, DirectionalLight, HemisphereLight, Mesh, PlaneGeometry, ShadowMaterial, Vector3, type Scene } from 'three';
import { drawsInSoftware } from './software';

const SUN = new Vector3(-0.55, -0.35, 1.25).normalize();
const SKY_LIGHT = 1.9;
const GROUND_SHARE = 0.5;
const SUN_RADIUS = 0.07;
/** Light of the sky from one place reaches fewer faces than light from everywhere. */
const SKY_FROM_ONE_PLACE = 2.6;
const SHADOW_PIXELS = drawsInSoftware ? 1024 : 2048;
const DOWN_TO = 0.35;
const GOLDEN = [0.7548776662466927, 0.5698402909980532];

/** Points that are well spread over the unit square, however many are taken. */
export const spread = (index: number, start = 0.5): [number, number] => [(start + GOLDEN[0] * index) % 1, (start + GOLDEN[1] * index) % 1];

const FLOOR_LIGHT = /* glsl */ `
float floorLight() {
  float light = 1.0;
#if NUM_DIR_LIGHT_SHADOWS > 0
  DirectionalLightShadow sun = directionalLightShadows[0];
  light = getShadow(directionalShadowMap[0], sun.shadowMapSize, sun.shadowIntensity, sun.shadowBias, sun.shadowRadius, vDirectionalShadowCoord[0]);
#endif
#if NUM_DIR_LIGHT_SHADOWS > 1
  DirectionalLightShadow sky = directionalLightShadows[1];
  light = mix(light, getShadow(directionalShadowMap[1], sky.shadowMapSize, sky.shadowIntensity, sky.shadowBias, sky.shadowRadius, vDirectionalShadowCoord[1]), 0.3);
#endif
  return light;
}
void main() {`;

/** Nothing but shadow; most of it the sun's. */
function floorMaterial(): ShadowMaterial {
  const material = new ShadowMaterial({ opacity: 0.26 });
  material.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('void main() {', FLOOR_LIGHT).replace('getShadowMask()', 'floorLight()');
  };
  return material;
}

export class Lights {
  private readonly sun = new DirectionalLight('#fff4e2', 2.9);
  private readonly sky = new HemisphereLight('#ffffff', '#a79f92', SKY_LIGHT);
  private readonly skyPlace = new DirectionalLight('#f4f8ff', SKY_FROM_ONE_PLACE);
  private readonly floor = new Mesh(new PlaneGeometry(1, 1), floorMaterial());
  private readonly center = new Vector3();
  private reach = 1;
  private shadowsOn = true;

  constructor(scene: Scene) {
    for (const light of [this.sun, this.skyPlace]) {
      light.shadow.mapSize.setScalar(SHADOW_PIXELS);
      light.shadow.radius = 1.5;
      scene.add(light, light.target);
    }
    this.floor.receiveShadow = true;
    const fill = new DirectionalLight('#dfe9ff', 0.7);
    fill.position.set(-2, 1.5, 1);
    scene.add(this.sky, this.floor, fill);
    this.quick(true);
  }

  /** For a surface within a box. */
  fit(box: Box3): void {
    box.getCenter(this.center);
    this.reach = box.getSize(new Vector3()).length() * 0.53 || 1;
    for (const { shadow } of [this.sun, this.skyPlace]) {
      shadow.camera.left = shadow.camera.bottom = -this.reach;
      shadow.camera.right = shadow.camera.top = this.reach;
      shadow.camera.near = 0.5 * this.reach;
      shadow.camera.far = 6 * this.reach;
      shadow.camera.updateProjectionMatrix();
      shadow.normalBias = 0.0014 * this.reach;
      shadow.bias = -0.0006;
    }
    this.floor.scale.setScalar(12 * this.reach);
    this.floor.position.set(this.center.x, this.center.y, Math.min(box.min.z, 0) - 0.05 * this.reach);
    this.place(this.sun, SUN);
  }

  set shadows(on: boolean) {
    this.shadowsOn = on;
    this.floor.visible = on;
  }

  private place(light: DirectionalLight, direction: Vector3): void {
    light.position.copy(this.center).addScaledVector(direction, 2.5 * this.reach);
    light.target.position.copy(this.center);
  }

  /** For one picture that is drawn at once. */
  quick(withShadow: boolean): void {
    this.sky.intensity = SKY_LIGHT;
    this.skyPlace.visible = false;
    this.sun.castShadow = this.shadowsOn && withShadow;
    this.floor.visible = this.sun.castShadow;
    this.place(this.sun, SUN);
  }

  /** For one of many pictures that are averaged. */
  sample(index: number): void {
    this.floor.visible = this.sun.castShadow = this.skyPlace.castShadow = this.skyPlace.visible = this.shadowsOn;
    if (!this.shadowsOn) return;
    this.sky.intensity = GROUND_SHARE * SKY_LIGHT;
    const [u, v] = spread(index);
    const across = new Vector3(SUN.y, -SUN.x, 0).normalize();
    const up = new Vector3().crossVectors(SUN, across);
    const [away, angle] = [SUN_RADIUS * Math.sqrt(u), 2 * Math.PI * v];
    this.place(this.sun, SUN.clone().addScaledVector(across, away * Math.cos(angle)).addScaledVector(up, away * Math.sin(angle)).normalize());
    const [height, turn] = spread(index, 0.17);
    const z = Math.max(Math.sqrt(height), DOWN_TO);
    const flat = Math.sqrt(1 - z * z);
    this.place(this.skyPlace, new Vector3(flat * Math.cos(2 * Math.PI * turn), flat * Math.sin(2 * Math.PI * turn), z));
  }
}

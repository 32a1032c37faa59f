// SPDX-License-Identifier: GPL-3.0-or-later
// The mean of many pictures of one thing: what differs between them (edges, light) comes out smooth.

import {
  CustomBlending, ConstantAlphaFactor, FloatType, HalfFloatType, Mesh, NearestFilter, NoBlending, OneMinusConstantAlphaFactor, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial,
  Vector2, WebGLRenderTarget, type Camera, type WebGLRenderer,
} from 'three';

const VERTEX = /* glsl */ `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`;
const COPY = /* glsl */ `
uniform sampler2D picture;
varying vec2 at;
void main() { gl_FragColor = texture2D(picture, at); }
`;
/** Colours are premultiplied and linear until here. */
const SHOW = /* glsl */ `
uniform sampler2D picture;
varying vec2 at;
void main() {
  vec4 mean = texture2D(picture, at);
  gl_FragColor = vec4(mean.rgb / max(mean.a, 1e-4), mean.a);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  gl_FragColor.rgb *= gl_FragColor.a;
}
`;

function sheet(fragmentShader: string, target: WebGLRenderTarget): ShaderMaterial {
  return new ShaderMaterial({ vertexShader: VERTEX, fragmentShader, uniforms: { picture: { value: target.texture } }, depthTest: false, depthWrite: false, blending: NoBlending });
}

export class Accumulator {
  private readonly one: WebGLRenderTarget;
  private readonly mean: WebGLRenderTarget;
  private readonly add: ShaderMaterial;
  private readonly show: ShaderMaterial;
  private readonly quad: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly flat = new Scene();
  private readonly eye = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  count = 0;

  constructor(private readonly renderer: WebGLRenderer) {
    const blends = renderer.getContext().getExtension('EXT_float_blend') !== null;
    const form = { minFilter: NearestFilter, magFilter: NearestFilter, generateMipmaps: false };
    this.one = new WebGLRenderTarget(1, 1, { ...form, type: HalfFloatType });
    this.mean = new WebGLRenderTarget(1, 1, { ...form, type: blends ? FloatType : HalfFloatType, depthBuffer: false });
    this.add = sheet(COPY, this.one);
    Object.assign(this.add, { blending: CustomBlending, transparent: true, blendSrc: ConstantAlphaFactor, blendDst: OneMinusConstantAlphaFactor });
    this.show = sheet(SHOW, this.mean);
    this.quad = new Mesh(new PlaneGeometry(2, 2), this.add);
    this.quad.frustumCulled = false;
    this.flat.add(this.quad);
  }

  restart(): void {
    this.count = 0;
    const size = this.renderer.getDrawingBufferSize(new Vector2());
    this.one.setSize(size.x, size.y);
    this.mean.setSize(size.x, size.y);
  }

  /** Draw once more, and take it into the mean. */
  take(scene: Scene, camera: Camera): void {
    const { renderer } = this;
    renderer.setRenderTarget(this.one);
    renderer.clear();
    renderer.render(scene, camera);
    ++this.count;
    this.add.blendAlpha = 1 / this.count;
    this.draw(this.add, this.mean);
  }

  present(): void {
    this.draw(this.show, null);
  }

  private draw(material: ShaderMaterial, target: WebGLRenderTarget | null): void {
    const clears = this.renderer.autoClear;
    const shadows = this.renderer.shadowMap.autoUpdate;
    this.quad.material = material;
    this.renderer.autoClear = false;
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.setRenderTarget(target);
    this.renderer.render(this.flat, this.eye);
    this.renderer.setRenderTarget(null);
    this.renderer.autoClear = clears;
    this.renderer.shadowMap.autoUpdate = shadows;
  }

  dispose(): void {
    this.one.dispose();
    this.mean.dispose();
    this.add.dispose();
    this.show.dispose();
    this.quad.geometry.dispose();
  }
}

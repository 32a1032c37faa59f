// SPDX-License-Identifier: GPL-3.0-or-later

import { ClampToEdgeWrapping, DataTexture, FloatType, LinearFilter, NearestFilter, RGBAFormat, Vector2, type IUniform } from 'three';
import { colourChoice, colourTable, TABLE_SIZE, type ColourMap } from './colours';

export interface BarUniforms {
  places: IUniform<DataTexture>;
  moves: IUniform<DataTexture>;
  turns: IUniform<DataTexture>;
  factor: IUniform<number>;
  section: IUniform<Vector2>;
  valuesOnBars: IUniform<number>;
  colours: IUniform<DataTexture>;
  valueRange: IUniform<Vector2>;
  colourOn: IUniform<number>;
  [name: string]: IUniform;
}

const WIDTH = 512;

/** A texture with four numbers for each node. */
export function nodeTexture(nodes: number): DataTexture {
  const height = Math.max(1, Math.ceil(nodes / WIDTH));
  const texture = new DataTexture(new Float32Array(4 * WIDTH * height), WIDTH, height, RGBAFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

const tables = new Map<string, DataTexture>();

export function colourTexture(map: ColourMap): DataTexture {
  const key = `${map} ${colourChoice.peek()}`;
  const known = tables.get(key);
  if (known) return known;
  const texture = new DataTexture(colourTable(map), TABLE_SIZE, 1, RGBAFormat);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.wrapS = ClampToEdgeWrapping;
  texture.needsUpdate = true;
  tables.set(key, texture);
  return texture;
}

export function barUniforms(): BarUniforms {
  return {
    places: { value: nodeTexture(1) },
    moves: { value: nodeTexture(1) },
    turns: { value: nodeTexture(1) },
    factor: { value: 1 },
    section: { value: new Vector2(0.002, 0.002) },
    valuesOnBars: { value: 0 },
    colours: { value: nodeTexture(1) }, // none yet
    valueRange: { value: new Vector2(0, 1) },
    colourOn: { value: 0 },
  };
}

/** Write three numbers a node into the first three channels. */
export function writeVectors(texture: DataTexture, vectors: Float32Array): void {
  const data = texture.image.data as unknown as Float32Array;
  for (let from = 0, to = 0; from < vectors.length; from += 3, to += 4) {
    data[to] = vectors[from];
    data[to + 1] = vectors[from + 1];
    data[to + 2] = vectors[from + 2];
  }
  texture.needsUpdate = true;
}

export function writeScalars(texture: DataTexture, scalars: Float32Array): void {
  const data = texture.image.data as unknown as Float32Array;
  for (let i = 0; i < scalars.length; ++i) data[4 * i + 3] = scalars[i];
  texture.needsUpdate = true;
}

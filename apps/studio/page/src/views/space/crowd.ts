// SPDX-License-Identifier: GPL-3.0-or-later

import { Color, InstancedMesh, Matrix4, MeshBasicMaterial, MeshStandardMaterial, type BufferGeometry, type Group, type Quaternion, type Vector3 } from 'three';

/** Many small things of one shape; room grows when needed. */
export class Crowd {
  mesh: InstancedMesh;
  private used = 0;
  private readonly matrix = new Matrix4();
  private readonly tint = new Color();

  constructor(private readonly geometry: BufferGeometry, private readonly group: Group, private readonly lit = true) {
    this.mesh = this.make(64);
  }
  private make(room: number): InstancedMesh {
    const mesh = new InstancedMesh(this.geometry, this.lit ? new MeshStandardMaterial({ roughness: 0.45 }) : new MeshBasicMaterial(), room);
    mesh.frustumCulled = false;
    mesh.castShadow = true;
    this.group.add(mesh);
    return mesh;
  }
  begin(room: number): void {
    this.used = 0;
    if (room <= this.mesh.instanceMatrix.count) return;
    this.group.remove(this.mesh);
    this.mesh.dispose();
    this.mesh = this.make(2 * room);
  }
  add(place: Vector3, turn: Quaternion, extent: Vector3, colour: string): void {
    this.mesh.setMatrixAt(this.used, this.matrix.compose(place, turn, extent));
    this.mesh.setColorAt(this.used, this.tint.set(colour));
    ++this.used;
  }
  end(): void {
    this.mesh.count = this.used;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
}

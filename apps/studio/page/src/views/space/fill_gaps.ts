// SPDX-License-Identifier: GPL-3.0-or-later
// Some models know only how the interface nodes move. For the drawing, what lies inside of a tile follows them: each interface
// node carries it along as a rigid body, and the nearer one counts for more.

import type { Beams, Solution } from '../../protocol/binary';

interface Follower {
  node: number;
  leaders: number[];
  weights: number[];
}

export class GapFiller {
  private readonly followers: Follower[];
  private readonly place: Float32Array;

  constructor(beams: Beams, interfaceOf: readonly (readonly number[])[], interfaceNodes: number) {
    this.place = beams.place;
    const tileOf = new Int32Array(beams.nodes).fill(-1);
    for (let beam = 0; beam < beams.beams; ++beam) {
      for (const end of [beams.ends[2 * beam], beams.ends[2 * beam + 1]]) if (end >= interfaceNodes) tileOf[end] = beams.tile[beam];
    }
    this.followers = [];
    for (let node = interfaceNodes; node < beams.nodes; ++node) {
      const leaders = interfaceOf[tileOf[node]];
      if (leaders) this.followers.push({ node, leaders: [...leaders], weights: leaders.map((leader) => this.weight(node, leader)) });
    }
    for (const follower of this.followers) {
      const sum = follower.weights.reduce((a, b) => a + b, 0);
      follower.weights = follower.weights.map((weight) => weight / sum);
    }
  }

  private weight(a: number, b: number): number {
    const p = this.place;
    const [x, y, z] = [p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]];
    return 1 / (x * x + y * y + z * z + 1e-12);
  }

  /** Whether a solution has gaps. */
  static needed({ displacement }: Solution): boolean {
    return Number.isNaN(displacement[displacement.length - 1]);
  }

  /** Put numbers where a solution has none. */
  fill(solution: Solution): void {
    const { displacement, rotation } = solution;
    for (const { node, leaders, weights } of this.followers) {
      if (!Number.isNaN(displacement[3 * node])) continue;
      const moved = [0, 0, 0, 0, 0, 0];
      leaders.forEach((leader, i) => this.carry(solution, node, leader, weights[i], moved));
      for (let c = 0; c < 3; ++c) {
        displacement[3 * node + c] = moved[c];
        rotation[3 * node + c] = moved[3 + c];
      }
    }
  }

  private carry({ displacement, rotation }: Solution, node: number, leader: number, weight: number, sum: number[]): void {
    const [n, l] = [3 * node, 3 * leader];
    const [dx, dy, dz] = [this.place[n] - this.place[l], this.place[n + 1] - this.place[l + 1], this.place[n + 2] - this.place[l + 2]];
    const [rx, ry, rz] = [rotation[l], rotation[l + 1], rotation[l + 2]];
    const angle = Math.hypot(rx, ry, rz);
    const s = angle > 1e-9 ? Math.sin(angle) / angle : 1;
    const c = angle > 1e-9 ? (1 - Math.cos(angle)) / (angle * angle) : 0.5;
    const [ax, ay, az] = [ry * dz - rz * dy, rz * dx - rx * dz, rx * dy - ry * dx];
    sum[0] += weight * (displacement[l] + s * ax + c * (ry * az - rz * ay));
    sum[1] += weight * (displacement[l + 1] + s * ay + c * (rz * ax - rx * az));
    sum[2] += weight * (displacement[l + 2] + s * az + c * (rx * ay - ry * ax));
    sum[3] += weight * rx;
    sum[4] += weight * ry;
    sum[5] += weight * rz;
  }
}

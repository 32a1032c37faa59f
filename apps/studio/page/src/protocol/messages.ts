// SPDX-License-Identifier: GPL-3.0-or-later
// The messages between server and page, as in apps/studio/protocol.md. Metres, newtons, radians.

export type Point = [number, number];
export type Vector = [number, number, number];
export type Dof = 'ux' | 'uy' | 'uz' | 'rx' | 'ry' | 'rz';
export const DOFS: readonly Dof[] = ['ux', 'uy', 'uz', 'rx', 'ry', 'rz'];

export type Side = 'left' | 'right' | 'bottom' | 'top';
/** A circle with its inside, m. */
export interface Circle {
  center: Point;
  radius: number;
}
/** Which interface nodes an entry of a load case is on: one of these keys. */
export interface Selection {
  nodes?: number[];
  box?: [number, number, number, number];
  circle?: Circle;
  nearest?: Point[];
  side?: Side;
  /** All nodes of these tiles; of loads on areas only. */
  tiles?: number[];
  /** The shorter way along the rim; of loads on lines only. */
  between?: [Point, Point];
}
export interface Support extends Selection {
  fixed: Dof[];
}
export interface Load extends Selection {
  force?: Vector;
  moment?: Vector;
  amount?: 'each' | 'total';
  /** N/m2; each node stands for its share of its tiles. */
  per_area?: Vector;
  /** N/m, along a side or between two points of the rim. */
  per_length?: Vector;
}
/** Which nodes a load is on, and how much of its vectors each of them bears. */
export interface LoadShares {
  nodes: number[];
  shares: number[];
  /** N and N m; for a load on an area or a line, the whole of it. */
  force: Vector;
  moment: Vector;
  /** The loaded area (m2) or length (m); null: neither. */
  extent: number | null;
}
/** The nodes that each entry of a load case acts on, as the program finds them; in the order of the entries. */
export interface Marks {
  supports: number[][];
  loads: LoadShares[];
  prescribed: number[][];
}
export type Prescribed = Selection & Partial<Record<Dof, number>>;
/** As it is sent to the program. */
export interface LoadCase {
  name: string;
  description?: string;
  supports?: Support[];
  loads?: Load[];
  prescribed?: Prescribed[];
  gravity?: Vector;
  /** Other load cases of the document that act as well, with their factors. */
  combines?: { load_case: string; factor: number }[];
}

/** As the program sends it. */
export interface SentLoadCase extends LoadCase {
  marks: Marks;
}

export interface Tile {
  vertices: number[];
  interface: number[];
}
/** By its numbers (a rectangle), or by the lengths of its type. */
export type Section =
  | { type?: undefined; area: number; I2: number; I3: number; J: number }
  | { type: 'circle'; diameter: number }
  | { type: 'tube'; outer_diameter: number; inner_diameter: number }
  | { type: 'I'; width: number; height: number; flange_thickness: number; web_thickness: number };
export interface Setting {
  material: { young_modulus: number; poisson_ratio: number; density: number; strength?: number };
  section: Section;
  tile_side: number;
  joints?: string;
  [other: string]: unknown;
}
export interface StudioDocument {
  name: string;
  path: string | null;
  saved: boolean;
  layout: string;
  layout_nodes?: Vector[];
  vertices: Point[];
  tiles: Tile[];
  interface_nodes: Point[];
  rim: number[][];
  /** The rim nodes along each side of the box. */
  sides: Record<Side, number[]>;
  palette: string[];
  painting: number[];
  turns: number[];
  tile_models: string[];
  setting: Setting;
  load_cases: SentLoadCase[];
  selected_load_case: number;
  model: string;
  linear?: boolean;
  recovered?: boolean;
  library?: string | null;
  history: { undo: string | null; redo: string | null };
}

export interface TileModel {
  name: string;
  summary: string;
  large_displacements: boolean;
  /** True: it has every bar of every tile, and others are compared with it. */
  reference?: boolean;
  /** Parameters that are fitted to the responses of a pattern: the model needs a library of these. */
  parameters?: { name: string; unit: string }[];
  /** Its name is followed by `:` and the share of tiles that have all of their bars, 0 to 1. */
  share?: boolean;
}
export interface Example {
  name: string;
  title: string;
  description: string;
}
export interface Hello {
  version: string;
  models: TileModel[];
  examples: Example[];
  layouts: string[];
  has_library: boolean;
  recoverable?: Recoverable[];
  /** The scales of drawings: their colours at equal distances, as "#rrggbb". */
  colours: Record<'sizes' | 'signed', string[]>;
  /** The files that it exports: their ending, such as ".svg", and content. */
  exports?: { ending: string; summary: string }[];
}

/** A document with changes that were not saved. */
export interface Recoverable {
  key: string;
  name: string;
  /** The path of its file; null: it has none. */
  path: string | null;
  /** Seconds since 1970. */
  time: number;
  tiles: number;
}

export interface Stiffness {
  young: number | null;
  shear: number | null;
  poisson: number | null;
}
export interface PatternRow {
  id: string;
  edges: number;
  mass: number | null;
  membrane: Stiffness | null;
  bending: Stiffness | null;
  symmetry: string | null;
  error: number | null;
}
export interface PatternTable {
  patterns: PatternRow[];
  nodes: Vector[];
}

export interface Reaction {
  node: number;
  force: Vector;
  moment: Vector;
}
export interface Solved {
  event: 'solved';
  revision: number;
  model: string;
  seconds: number;
  residual: number;
  /** null: not known yet, since loads are being dragged. */
  stable: boolean | null;
  load_factor: number;
  /** Bent so far that the model may be off: its error is estimated. null: nothing is known. */
  doubtful: boolean | null;
  converged: boolean;
  warnings: string[];
  largest_displacement: number;
  fields: string[];
  reactions?: Reaction[];
  background?: boolean;
  /** The first step towards the answer. The answer follows. */
  provisional?: boolean;
  step?: number;
  steps?: number;
}

/** A displacement; null: this component is free. */
export type FreeVector = [number | null, number | null, number | null];
/** A target as in files, without its format. */
export interface TargetGoals {
  goals: { nodes: number[]; displacements: FreeVector[] }[];
}
/** How a design is doing. */
export interface Designing {
  /** Nonlinear solutions so far, and the most of them; 0: as many as the design takes by itself. */
  solutions: number;
  most: number;
  seconds: number;
  /** Root of the mean square distance, a share of the largest displacement wanted; null: not known yet. */
  misfit: number | null;
}
/** A line of the program whose lengths and angles the page shows in its units: `{0}` stands for the first value (SI). */
export interface WarningParts {
  text: string;
  values: { value: number; quantity: 'length' | 'angle' }[];
}
/** The result of a design, whose painting is the document's now. Errors are shares of the largest displacement wanted. */
export interface Designed {
  /** A first painting: the search goes on. */
  sketch: boolean;
  /** With all bars; null: it was stopped before that was known. */
  error_mean: number | null;
  error_largest: number | null;
  stable: boolean | null;
  /** Of the best single pattern. */
  error_best_uniform: number | null;
  best_uniform_pattern: string;
  uniform_tried: number;
  /** The share of that error that the design has taken away. */
  share_closed: number | null;
  is_better: boolean;
  patterns: string[];
  load_cases: string[];
  factors: number[];
  warnings: string[];
  warning_parts: WarningParts[];
  /** How it ended, in words. */
  words: string;
  seconds: number;
  solutions: number;
  full_solutions: number;
}
/** The estimated distance of the live solution from the full model's, as shares of the largest displacement. */
export interface EstimatedError {
  mean: number;
  largest: number;
  /** Of the largest stress, a share of it; null: not known. */
  largest_stress: number | null;
  is_warned: boolean;
}

/** Where bars overlap, or what is cut is narrower than can be cut. */
export interface MakingPlace {
  kind: 'overlap' | 'gap' | 'opening';
  place: Point;
  /** In metres; below zero of an overlap. */
  width: number;
}
export interface Making {
  /** Empty: nothing prevents making the surface. */
  words: string[];
  /** How many there are, also beyond those that are listed. */
  counts: Record<MakingPlace['kind'], number>;
  places: MakingPlace[];
}

/** How many patterns a count of a layout has found by now. */
export interface CountSoFar {
  /** That of the request. */
  key: number;
  patterns: number;
}

export type ServerEvent =
  | ({ event: 'document'; revision: number } & StudioDocument)
  | ({ event: 'changed'; revision: number } & Partial<StudioDocument>)
  | { event: 'solving'; revision: number; model: string; share: number; background?: boolean }
  | Solved
  | { event: 'failed'; revision: number; model: string; error: string; background?: boolean }
  | { event: 'modes'; revision: number; values: number[]; kind: 'vibration' | 'buckling' }
  | { event: 'compared'; revision: number; model: string; mean: number; largest: number; relative: number }
  | ({ event: 'making'; revision: number } & Making)
  | ({ event: 'designing'; revision: number } & Designing)
  | ({ event: 'designed'; revision: number } & Designed)
  | ({ event: 'model_error'; revision: number; model: string } & EstimatedError)
  | { event: 'warning'; revision: number; text: string }
  | ({ event: 'layout_count'; revision: number } & CountSoFar);

/** A file that `save` would replace, and that nobody here has seen. */
export interface SaveConflict {
  path: string;
  /** The hash that the next `save` names as the content it replaces. */
  hash: string;
  /** `changed`: another program wrote the document's own file; `exists`: another project lies there. */
  reason: 'changed' | 'exists';
}
export type Answer = { id: number; ok: true } | { id: number; ok: false; error: string; conflict?: SaveConflict };

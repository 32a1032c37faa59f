// SPDX-License-Identifier: GPL-3.0-or-later
// The requests of the page and their answers, as in apps/studio/protocol.md.

import type { Hello, LoadCase, PatternTable, Point, Recoverable, Setting, TargetGoals, Vector } from './messages';

/** A file of the browser's machine. */
export interface SentFile {
  name: string;
  text_base64: string;
}
export interface SentOutline extends SentFile {
  /** "largest", "all", or a number as text, "1" the largest. */
  part?: string;
  /** In metres: the outline is scaled to it. */
  width?: number;
}
/** An outline as the server has read it. */
export interface Measured {
  /** Width and height as drawn, in metres. */
  size: Point;
  /** Without holes, in square metres. */
  area: number;
  loops: Point[][];
  /** The sizes of all parts of the drawing, the largest part first. */
  parts: Point[];
  /** Remarks on changes to the drawing. */
  remarks?: string[];
}

/** In requests that replace the present document: its unsaved changes are given up. */
export interface Discarding {
  discard?: true;
}
/** Edits with the same key that follow one another are one step of undo. */
interface Merging {
  merge?: string;
}
interface Edited {
  /** Then no event follows. */
  unchanged?: boolean;
  /** Remarks on how it was done. */
  remarks?: string[];
}
interface Made {
  tiles: number;
  remarks?: string[];
}

/** The first patterns, in the words of `fretwork tile`. */
export interface FirstPatterns {
  patterns?: string;
}
/** Where the tiles come from: new ones of a side in metres, or the faces of a mesh. */
export type TilesWanted = { tile_size: number } | { tiles: 'faces' };
export type NewDocument = Discarding & ({ example: string } | ({ outline: SentOutline } & TilesWanted & FirstPatterns));

export type PaintRequest = Merging &
  (
    | { tiles: readonly number[]; pattern: string }
    /** A choice in the words of `fretwork paint`; without `tiles`, it paints all tiles. */
    | { tiles?: readonly number[]; patterns: string; palette: string; file?: SentFile }
  );

/** Each as the option of `fretwork design`. */
export interface DesignRequest {
  target: TargetGoals;
  /** The tiles that may change; left out: all. */
  tiles?: readonly number[];
  palette?: string;
  max_patterns?: number;
  free?: ('factor' | 'prescribed')[];
  seconds?: number;
  solutions?: number;
  seed?: number;
}

/** Something in a folder of the server's machine. */
export interface FolderEntry {
  name: string;
  path: string;
  /** Seconds since 1970, of its last change. */
  time: number;
}
export interface FolderListing {
  path: string;
  /** null at the top. */
  parent: string | null;
  home: string | null;
  folders: FolderEntry[];
  files: FolderEntry[];
  /** How many further entries there are, beyond the most that are listed. */
  left_out: number;
}

/** Other tiles for the outline of the document. */
export interface RetileRequest {
  tile_size: number;
  /** Of the rows of tiles, in radians; left out: the most regular tiling. */
  angle?: number;
  /** The name of a layout; left out: the document's. */
  layout?: string;
  /** `keep`: stay by place; `made:one`: a pattern that can be made; else the id of one for all tiles. */
  patterns?: string;
  preview?: true;
}
/** The new tiles, made or previewed. */
export interface Retiled {
  tiles: number;
  interface_nodes: number;
  /** Lengths of the sides, in metres. */
  side: { mean: number; deviation: number; smallest: number; largest: number };
  /** In radians. */
  smallest_angle: number;
  hexagon_share: number;
  refined_share: number;
  /** Entries of load cases on nodes by number, which cannot be kept. */
  dropped: { supports: number; loads: number; prescribed: number };
  /** How many tiles each kind of painting by place has painted: `field`, `image`, `colours`, `random`. */
  painted_again: Record<string, number>;
  unpainted: number;
  remarks: string[];
  /** In previews. */
  vertices?: Point[];
  polygons?: number[][];
}

/** A layout as in its file: coordinates are exact numbers in quotes. */
export interface LayoutFile {
  format: string;
  name: string;
  center: boolean;
  corners: boolean;
  radial: string[];
  face: [string, string, string][];
  interface: string[];
}
export type NodeKind = 'center' | 'radial' | 'face' | 'interface';
export interface LayoutNode {
  kind: NodeKind;
  /** Barycentric, for v0, v1 and v2. */
  place: Vector;
  exact: [string, string, string];
  /** The nodes that move with it; those of a face node do so only with `mirror`. */
  twins: number[];
}
/** A layout with its nodes and candidate edges. */
export interface LayoutLook {
  layout: LayoutFile;
  nodes: LayoutNode[];
  edges: [number, number][];
}
export type LayoutChange = { move: number; to: Vector } | { add: NodeKind; to?: Vector } | { remove: number };
export interface DrawLayout {
  layout: LayoutFile;
  change?: LayoutChange;
  /** Nodes go to multiples of 1 / grid. */
  grid?: number;
  /** Whether face nodes take their mirror images along. */
  mirror?: boolean;
}
/** The valid patterns of a layout. */
export interface LayoutCount {
  patterns: number;
  /** false: there are more. */
  complete: boolean;
  /** Ids of some of those that were found. */
  samples: string[];
}

type Nothing = Record<never, never>;

/** Each request with what it says, and with its answer. */
export interface Requests {
  hello: { says: { protocol: 1; fields: readonly string[] }; answer: Hello };
  show: { says: { fields: readonly string[] }; answer: Nothing };
  patterns: { says: { layout?: string }; answer: PatternTable };

  measure: { says: { outline: SentOutline }; answer: Measured };
  new: { says: NewDocument; answer: Made };
  open: { says: Discarding & { path: string }; answer: Nothing };
  upload: { says: Discarding & SentFile; answer: Nothing };
  recoverable: { says: Nothing; answer: { recoverable: Recoverable[] } };
  recover: { says: Discarding & { key: string }; answer: Nothing };
  forget: { says: { key: string }; answer: { recoverable: Recoverable[] } };
  folder: { says: { path?: string; endings?: readonly string[] }; answer: FolderListing };
  save: { says: { path?: string; replaces?: string }; answer: { path: string } };
  download: { says: Nothing; answer: { text: string } };

  paint: { says: PaintRequest; answer: Edited };
  turn: { says: { tiles: readonly number[]; by: number }; answer: Edited };
  set_model: { says: { model: string; linear?: boolean }; answer: Edited };
  set_tile_model: { says: { tiles: readonly number[]; model: string }; answer: Edited };
  set_setting: { says: Merging & { setting: Setting }; answer: Edited };
  set_load_case: { says: Merging & { index: number; load_case: LoadCase }; answer: Edited };
  remove_load_case: { says: { index: number }; answer: Edited };
  select_load_case: { says: { index: number }; answer: Nothing };
  retile: { says: RetileRequest; answer: Retiled };
  undo: { says: Nothing; answer: Nothing };
  redo: { says: Nothing; answer: Nothing };

  open_layout: { says: { from: string }; answer: LayoutLook & { path: string | null; hash: string | null } };
  draw_layout: { says: DrawLayout; answer: LayoutLook & { node: number | null } };
  count_layout: { says: { layout: LayoutFile; key: number }; answer: LayoutCount };
  save_layout: { says: { layout: LayoutFile; path: string; replaces?: string }; answer: { path: string; hash: string } };

  design: { says: DesignRequest; answer: Nothing };
  stop_design: { says: Nothing; answer: Nothing };

  solve: { says: { model: string; background: true }; answer: Nothing };
  path: { says: { steps: number }; answer: Nothing };
  modes: { says: { count: number }; answer: Nothing };
  buckling: { says: { count: number }; answer: Nothing };
  compare: { says: { model: string }; answer: Nothing };
  cancel: { says: Nothing; answer: Nothing };
}
export type RequestName = keyof Requests;
export type Says<Name extends RequestName> = Requests[Name]['says'];
export type AnswerTo<Name extends RequestName> = Requests[Name]['answer'];
/** The argument after the name of a request; none where the request has no keys. */
export type More<Name extends RequestName> = Nothing extends Says<Name> ? [says?: Says<Name>] : [says: Says<Name>];

// SPDX-License-Identifier: GPL-3.0-or-later
// The surface in space, kept in step with the document: bars of the live model, of others laid over it, and the load case's marks.

import { effect } from '@preact/signals';
import { Box3, Vector3 } from 'three';
import { field, projection, ranges, scale, shadows, showMarks, showRest, type FieldName } from '../../document/look';
import { heldNodes, loadMarks, prescribedMarks } from '../../document/marks';
import { fullUnderneath, shown, shownOfBars, UNDERNEATH } from '../../document/shown';
import { barSection, beams, compared, live, shapes, strength } from '../../document/store';
import { surface } from '../../document/surface';
import { liveTarget, target } from '../../document/target';
import { activeEntry, mode, selectedNodes } from '../../document/ui';
import { theme, themeColour } from '../../manners/theme';
import type { Beams } from '../../protocol/binary';
import { Bars } from './bars';
import { colourChoice, type ColourMap } from './colours';
import { FieldValues, fieldRow, available, MODE_ROW, type Values } from './fields';
import { GapFiller } from './fill_gaps';
import { arrowScale, MarksView, type ArrowScale } from './marks_view';
import { handles } from './handles';
import { interpolated, legend } from './legend_state';
import { nodePlace, onScreen } from './placed';
import { Stage, type ViewName } from './stage';
import { TargetView } from './target_view';

/** Solutions whose gaps were filled for the drawing. */
const filled = new WeakSet<object>();
/** How far the view follows bent places, in sizes of the flat surface: at first, and to see all. */
const MOST_SHOWN = 0.35;
const ALL_SHOWN = 3;
const BLUE = '#4a8ee0';
const GREY = '#9b9fa5';

export class SceneView {
  readonly stage: Stage;
  arrows: ArrowScale = { force: 1, moment: 1 };
  /** While an arrow is dragged, its scale stays. */
  dragging = false;
  readonly main = new Bars({ colour: '#777', opacity: 1 });
  private readonly full = new Bars({ colour: GREY, opacity: 1 });
  private readonly rest = new Bars({ colour: GREY, opacity: 0.25 });
  private readonly all = [this.main, this.full, this.rest];
  private readonly marks = new MarksView();
  private readonly target = new TargetView();
  private readonly values = new FieldValues();
  /** What the bars of the live model are coloured by; null: one colour. */
  valuesNow: Values | null = null;
  private filler: { of: Beams; gaps: GapFiller } | null = null;
  /** The surface that the camera was last set for; it is set again when the surface is bent for the first time. */
  private framed: { of: object; bent: boolean } | null = null;
  private readonly stops: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement) {
    this.stage = new Stage(canvas);
    for (const bars of this.all) this.stage.scene.add(bars.group);
    this.stage.scene.add(this.marks.group, this.target.group);
    this.stage.beforeDraw((quality) => quality === 'fine' && this.stage.light(new Box3().setFromPoints(this.places())));
    this.stage.beforeDraw((quality) => this.all.forEach((bars) => (bars.quality = quality)));
    this.stops.push(
      effect(() => this.showBars()),
      effect(() => this.showShape()),
      effect(() => this.showOverlays()),
      effect(() => this.showMarkers()),
      effect(() => this.showTarget()),
      effect(() => this.frame()),
      effect(() => void (this.stage.shadows = shadows.value)),
      effect(() => void (this.stage.projection = projection.value)),
    );
  }

  dispose(): void {
    this.stops.forEach((stop) => stop());
    this.stage.dispose();
  }

  private showBars(): void {
    const now = beams.value;
    this.main.group.visible = now !== null && now.beams > 0;
    const section = barSection.value;
    if (!now) return;
    for (const bars of [this.main, this.rest]) bars.setBeams(now, section);
    this.full.setBeams(now, { width: UNDERNEATH * section.width, height: UNDERNEATH * section.height });
    this.rest.factor = 0;
    this.showShape();
    this.stage.draw();
  }

  private showShape(): void {
    const now = shownOfBars.value;
    const bars = beams.value;
    const name = field.value;
    const dark = theme.value === 'dark';
    void colourChoice.value;
    if (!now || !bars) {
      this.main.factor = 0;
      this.setColours(null, 'sizes');
      this.main.colour = dark ? '#c3c8cf' : '#b4b7bb';
      legend.value = null;
      this.stage.draw();
      return;
    }
    if (GapFiller.needed(now.solution)) {
      this.gaps(bars)?.fill(now.solution);
      filled.add(now.solution);
    }
    interpolated.value = filled.has(now.solution);
    this.main.setSolution(now.solution);
    this.main.factor = now.factor;
    this.main.colour = BLUE;
    this.colour(name, now);
    this.stage.draw();
  }

  private colour(name: FieldName, now: NonNullable<typeof shown.value>): void {
    if (shapes.value && shapes.value.kind !== 'path') return this.colourMode(name, now);
    // The error is known of the live answer alone, not of the steps towards it.
    const row = fieldRow(shapes.value && name === 'error' ? 'displacement' : name);
    const error = compared.value?.solution?.nodeFields[0] ?? null;
    const usable = available(row, error !== null);
    const values = usable ? this.values.take(row, now.solution, now.fields, { error, strength: strength.value }) : null;
    const set = ranges.value[row.name];
    if (values && set) Object.assign(values, { ...set, isCut: true });
    this.setColours(values, row.map);
    legend.value = values && { row, low: values.low, high: values.high, isCut: values.isCut };
  }

  private setColours(values: Values | null, map: ColourMap): void {
    this.valuesNow = values;
    this.main.setColours(values, map);
  }

  private colourMode(name: FieldName, now: NonNullable<typeof shown.value>): void {
    const values = name === 'plain' ? null : this.values.take(MODE_ROW, now.solution, [], { error: null, strength: null });
    this.setColours(values, MODE_ROW.map);
    legend.value = values && { row: MODE_ROW, low: 0, high: 1, isCut: false };
  }

  private gaps(bars: Beams): GapFiller | null {
    const tiles = surface.peek();
    if (!tiles) return null;
    if (this.filler?.of !== bars) {
      this.filler = { of: bars, gaps: new GapFiller(bars, tiles.tiles.map((tile) => tile.interface), tiles.nodes.length) };
    }
    return this.filler.gaps;
  }

  private showOverlays(): void {
    const full = fullUnderneath.value;
    this.full.group.visible = full !== null;
    if (full) {
      this.full.setSolution(full);
      this.full.factor = scale.value;
    }
    this.rest.group.visible = showRest.value && beams.value !== null;
    this.stage.draw();
  }

  private showMarkers(): void {
    for (const signal of [heldNodes, loadMarks, prescribedMarks, selectedNodes, activeEntry, shown, theme, mode]) void signal.value;
    this.marks.group.visible = showMarks.value;
    const tiles = surface.value;
    if (!tiles) return;
    themeColour('--fixed');
    const reach = Math.hypot(tiles.box.max[0] - tiles.box.min[0], tiles.box.max[1] - tiles.box.min[1]);
    if (!this.dragging) this.arrows = arrowScale(loadMarks.value, reach);
    this.marks.update(tiles.side, this.arrows);
    this.stage.draw();
  }

  private showTarget(): void {
    for (const signal of [target, liveTarget, shown, theme]) void signal.value;
    this.target.group.visible = mode.value === 'design';
    const tiles = surface.value;
    if (tiles) this.target.update(tiles.side);
    this.stage.draw();
  }

  /** Where the surface is, flat and bent. */
  private places(most = MOST_SHOWN, only: 'bent' | 'both' = 'both'): Vector3[] {
    const nodes = surface.peek()?.nodes ?? [];
    const flat = nodes.map(([x, y]) => new Vector3(x, y, 0));
    const box = new Box3().setFromPoints(flat);
    // A linear model may send nodes absurdly far: the view stays with the surface.
    const room = box.clone().expandByScalar(most * box.getSize(new Vector3()).length());
    const bent = shown.peek() ? nodes.map((_, node) => nodePlace(node)).map((place) => room.clampPoint(place, place)) : [];
    const shape = bent.length > 0 && only === 'bent' ? [] : flat;
    return [...shape, ...bent, ...handles(this.arrows).map(({ place }) => room.clampPoint(place, place))];
  }

  private frame(): void {
    const tiles = surface.value;
    const bent = live.value !== null;
    if (!tiles || (this.framed?.of === tiles && (this.framed.bent || !bent))) return;
    const first = this.framed?.of !== tiles;
    this.framed = { of: tiles, bent };
    const places = this.places();
    this.stage.light(new Box3().setFromPoints(places));
    if (first || this.stage.untouched) this.stage.look({ places, from: 'iso' });
  }

  /** Where the handles are on the canvas, in pixels. */
  handlePlaces(): ([number, number] | null)[] {
    return handles(this.arrows).map(({ place }) => this.placeOnCanvas(place));
  }

  placeOnCanvas(place: Vector3): [number, number] | null {
    const { clientWidth: width, clientHeight: height } = this.stage.renderer.domElement;
    this.stage.camera.updateMatrixWorld();
    return onScreen(place, this.stage.camera, { width, height });
  }

  /** Metres across the view for a pixel of the page; null in perspective, where they differ. */
  get metresPerPixel(): number | null {
    return this.stage.metresPerPixel;
  }

  look(from: ViewName | null): void {
    this.stage.look({ places: this.places(ALL_SHOWN, showRest.peek() ? 'both' : 'bent'), from });
  }
}

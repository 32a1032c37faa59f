// SPDX-License-Identifier: GPL-3.0-or-later

import { setSetting } from '../document/edits';
import { BarSlider } from './bar_slider';
import { sizeOf } from '../document/section';
import { documentNow } from '../document/store';
import type { Setting } from '../protocol/messages';
import { Choice } from '../widgets/widgets';
import { NumberField } from '../widgets/number';
import { W } from '../words';

interface Preset {
  name: string;
  young_modulus: number;
  density: number;
}
const PRESETS: Preset[] = [
  { name: W.materialFields.paperGpa, young_modulus: 1e9, density: 1240 },
  { name: 'PLA', young_modulus: 2.3465e9, density: 1240 },
  { name: 'PETG', young_modulus: 2.0e9, density: 1270 },
  { name: W.materialFields.plywood, young_modulus: 9e9, density: 680 },
];

const presetOf = (material: Setting['material']): Preset | undefined =>
  PRESETS.find((row) => row.young_modulus === material.young_modulus && row.density === material.density);
export const materialName = (material: Setting['material']): string => presetOf(material)?.name ?? W.materialFields.customMaterial;

const torsion = (a: number, b: number): number => {
  const [long, short] = [Math.max(a, b), Math.min(a, b)];
  return long * short ** 3 * (1 / 3 - 0.21 * (short / long) * (1 - (short / long) ** 4 / 12));
};

const section = (width: number, height: number) => ({
  area: width * height,
  I2: (width * height ** 3) / 12,
  I3: (height * width ** 3) / 12,
  J: torsion(width, height),
});

export function MaterialFields() {
  const setting = documentNow.value?.setting;
  if (!setting) return null;
  const { material } = setting;
  const { width, height } = sizeOf(setting.section);
  const isRectangle = setting.section.type === undefined;
  // The newest format; the server writes the oldest one that has all keys.
  const withPart = (part: Partial<Setting>): Setting => ({ ...setting, format: 'fretwork/setting/3', ...part });
  const change = (part: Partial<Setting>) => setSetting(withPart(part));
  const bears = (strength: number | undefined) => change({ material: { ...material, strength } });
  const preset = presetOf(material);
  return (
    <>
      <div class="field"><span>{W.materialFields.material}</span>
        <Choice label={W.materialFields.material} value={preset?.name ?? ''} options={[...(preset ? [] : [{ value: '', title: W.materialFields.custom }]), ...PRESETS.map(({ name }) => ({ value: name, title: name }))]}
          onPick={(name) => {
            const row = PRESETS.find((one) => one.name === name);
            // The strength was that of the old material.
            if (row) change({ material: { ...material, strength: undefined, young_modulus: row.young_modulus, density: row.density } });
          }} />
      </div>
      <label class="field"><span>{W.materialFields.youngSModulus}</span>
        <NumberField label={W.materialFields.youngSModulus2} least={1} value={material.young_modulus} quantity="stress" onChange={(young_modulus) => change({ material: { ...material, young_modulus } })} />
      </label>
      <label class="field" title={W.materialFields.stressAtFailureUtilization}><span>{W.materialFields.strength}</span>
        <NumberField label={W.materialFields.materialStrength} least={1} value={material.strength} quantity="stress" onChange={bears} onClear={() => bears(undefined)} />
      </label>
      {!isRectangle && <p class="hint">{W.materialFields.otherSection(setting.section.type ?? '')}</p>}
      <label class="field"><span>{W.materialFields.barWidthInPlane}</span>
        <NumberField label={W.materialFields.barWidth} least={1e-5} value={width} quantity="length" onChange={(value) => change({ section: section(value, height) })} />
      </label>
      {isRectangle && <BarSlider id="bar-width" label={W.materialFields.slideBarWidth} value={width} setting={setting} settingOf={(value) => withPart({ section: section(value, height) })} />}
      <label class="field"><span>{W.materialFields.barHeight}</span>
        <NumberField label={W.materialFields.barHeight} least={1e-5} value={height} quantity="length" onChange={(value) => change({ section: section(width, value) })} />
      </label>
      {isRectangle && <BarSlider id="bar-height" label={W.materialFields.slideBarHeight} value={height} setting={setting} settingOf={(value) => withPart({ section: section(width, value) })} />}
      <div class="field" title={W.materialFields.stiffJointsHaveA}><span>{W.materialFields.joints}</span>
        <Choice label={W.materialFields.joints} value={setting.joints ?? 'centreline'} options={[{ value: 'centreline', title: W.materialFields.points }, { value: 'stiff', title: W.materialFields.stiff }]}
          onPick={(joints) => change({ joints })} />
      </div>
    </>
  );
}

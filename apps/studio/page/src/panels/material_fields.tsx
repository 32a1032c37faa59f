// SPDX-License-Identifier: GPL-3.0-or-later

import { setSetting } from '../document/edits';
import { sizeOf } from '../document/section';
import { documentNow } from '../document/store';
import type { Setting } from '../protocol/messages';
import { Choice } from '../widgets/widgets';
import { NumberField } from '../widgets/number';

interface Preset {
  name: string;
  young_modulus: number;
  density: number;
}
const PRESETS: Preset[] = [
  { name: 'The paper’s, 1 GPa', young_modulus: 1e9, density: 1240 },
  { name: 'PLA', young_modulus: 2.3465e9, density: 1240 },
  { name: 'PETG', young_modulus: 2.0e9, density: 1270 },
  { name: 'Plywood', young_modulus: 9e9, density: 680 },
];

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
  // The newest format; the server keeps the first that a setting needs.
  const change = (part: Partial<Setting>) => setSetting({ ...setting, format: 'fretwork/setting/3', ...part });
  const bears = (strength: number | undefined) => change({ material: { ...material, strength } });
  const preset = PRESETS.find((row) => row.young_modulus === material.young_modulus && row.density === material.density);
  return (
    <>
      <div class="field"><span>Material</span>
        <Choice label="Material" value={preset?.name ?? ''} options={[...(preset ? [] : [{ value: '', title: 'own' }]), ...PRESETS.map(({ name }) => ({ value: name, title: name }))]}
          onPick={(name) => {
            const row = PRESETS.find((one) => one.name === name);
            // The strength is that of the material before.
            if (row) change({ material: { ...material, strength: undefined, young_modulus: row.young_modulus, density: row.density } });
          }} />
      </div>
      <label class="field"><span>Young’s modulus</span>
        <NumberField label="Young's modulus" least={1} value={material.young_modulus} quantity="stress" onChange={(young_modulus) => change({ material: { ...material, young_modulus } })} />
      </label>
      <label class="field" title="The stress that the material bears: utilization is a share of it"><span>Strength</span>
        <NumberField label="Strength of the material" least={1} value={material.strength} quantity="stress" onChange={bears} onClear={() => bears(undefined)} />
      </label>
      {!isRectangle && <p class="hint">The bars are of type {setting.section.type}; a width or height given here makes them rectangles.</p>}
      <label class="field"><span>Bar width, in the plane</span>
        <NumberField label="Bar width" least={1e-5} value={width} quantity="length" onChange={(value) => change({ section: section(value, height) })} />
      </label>
      <label class="field"><span>Bar height</span>
        <NumberField label="Bar height" least={1e-5} value={height} quantity="length" onChange={(value) => change({ section: section(width, value) })} />
      </label>
      <div class="field" title="Real bars merge in joints that have a size: stiff joints are nearer to what is printed or cut, centrelines are the paper’s model"><span>Joints</span>
        <Choice label="Joints" value={setting.joints ?? 'centreline'} options={[{ value: 'centreline', title: 'points' }, { value: 'stiff', title: 'stiff' }]}
          onPick={(joints) => change({ joints })} />
      </div>
    </>
  );
}

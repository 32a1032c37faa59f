// SPDX-License-Identifier: GPL-3.0-or-later
// Playback of a load path or of modes.

import { Pause, Play, Video, X } from 'lucide-preact';
import { saveVideo } from '../../document/files';
import { playing, shapeIndex } from '../../document/look';
import { play, stop } from '../../document/shown';
import { shapes } from '../../document/store';
import { digits } from '../../document/units';
import { Button } from '../../widgets/widgets';
import { W } from '../../words';
import { canRecord, recorded } from '../pictures/record';

export function PlayBar() {
  const now = shapes.value;
  if (!now || now.shapes.length === 0) return null;
  const index = Math.min(shapeIndex.value, now.shapes.length - 1);
  const words = {
    path: W.playBar.ofTheLoad(digits(100 * (now.values[index] ?? 0))),
    vibration: W.playBar.modeHz(index + 1, digits(now.values[index] ?? 0)),
    buckling: W.playBar.modeAtTheLoad(index + 1, digits(now.values[index] ?? 0)),
  }[now.kind];
  const close = () => {
    stop();
    shapes.value = null;
  };
  return (
    <div class="card play-bar" role="group" aria-label={W.playBar.playback}>
      <Button kind="bare" title={playing.value ? W.playBar.pause : W.playBar.animate} icon={playing.value ? Pause : Play} onPress={() => (playing.value ? stop() : play())} />
      <input type="range" aria-label={now.kind === 'path' ? W.playBar.step : W.playBar.mode} min={0} max={now.shapes.length - 1} value={index}
        onInput={(event) => {
          if (now.kind === 'path') stop();
          shapeIndex.value = Number(event.currentTarget.value);
        }} />
      <output>{recorded.value === null ? words : W.record.share(Math.round(100 * recorded.value))}</output>
      {canRecord() && <Button kind="bare" id="record" title={recorded.value === null ? W.record.video : W.record.recording} icon={Video} disabled={recorded.value !== null || now.shapes.length < now.expected} onPress={() => void saveVideo()} />}
      <Button kind="bare" title={W.playBar.close} icon={X} onPress={close} />
    </div>
  );
}

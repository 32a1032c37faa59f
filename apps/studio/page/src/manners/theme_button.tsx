// SPDX-License-Identifier: GPL-3.0-or-later

import { Moon, Sun } from 'lucide-preact';
import { Button } from '../widgets/widgets';
import { W } from '../words';
import { switchTheme, theme } from './theme';

/** Shows the theme that a press leads to. */
export function ThemeButton() {
  const isLight = theme.value === 'light';
  return <Button kind="bare" title={isLight ? W.topBar.darkTheme : W.topBar.lightTheme} icon={isLight ? Moon : Sun} onPress={switchTheme} />;
}

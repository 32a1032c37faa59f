// SPDX-License-Identifier: GPL-3.0-or-later
// The connection to the server: requests to it, and who takes its messages.

import { batch, effect } from '@preact/signals';
import { Connection } from '../protocol/connection';
import type { AnswerTo, More, RequestName } from '../protocol/requests';
import { forgetAwaited, takeBinary, takeEvent } from './events';
import { beamFields } from './look';
import * as store from './store';
import { tell } from './tell';

function socketAddress(): string {
  const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
  return `${scheme}://${location.host}/socket${location.search}`;
}

/** Whether a server answers but refuses this address, because the address is from an earlier run. */
const isRefused = (): Promise<boolean> =>
  fetch(`/${location.search}`, { method: 'HEAD' }).then((answer) => answer.status === 403, () => false);

const connection = new Connection(socketAddress(), { state: showLine, event: takeEvent, binary: takeBinary, opened, isRefused });

export const start = (): void => connection.open();
/** As if the line were cut; it mends itself. */
export const cut = (): void => connection.cut();
export const ask = <Name extends RequestName>(what: Name, ...says: More<Name>): Promise<AnswerTo<Name>> => connection.ask(what, ...says);

/** Ask, and show the server's words if it refuses. Resolves to null then. */
export async function tryAsk<Name extends RequestName>(what: Name, ...says: More<Name>): Promise<AnswerTo<Name> | null> {
  try {
    return await ask(what, ...says);
  } catch (error) {
    tell((error as Error).message, 'error');
    return null;
  }
}

/** Notices say whether the line is open. */
function showLine(state: typeof store.line.value): void {
  store.line.value = state;
}

function opened(): void {
  forgetAwaited();
  void ask('hello', { protocol: 1, fields: beamFields.peek() }).then(
    (answer) => batch(() => {
      store.hello.value = answer;
      store.recoverable.value = answer.recoverable ?? [];
    }),
    (error: Error) => tell(error.message, 'error'),
  );
}

/** Tells the server which fields are shown, because it sends only these. */
effect(() => {
  const fields = beamFields.value;
  if (store.hello.peek()) void ask('show', { fields }).catch(() => undefined);
});

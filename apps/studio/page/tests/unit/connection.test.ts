// SPDX-License-Identifier: GPL-3.0-or-later
// The line to the server: when it is lost, and found again.
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { Connection } from '../../src/protocol/connection';

class FakeSocket {
  static readonly OPEN = 1;
  static all: FakeSocket[] = [];
  readyState = 0;
  onopen = (): void => undefined;
  onclose = (): void => undefined;
  constructor(readonly address: string) {
    FakeSocket.all.push(this);
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('WebSocket', FakeSocket);
  FakeSocket.all = [];
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it('stays lost while it is tried again, until it is open', async () => {
  const states: string[] = [];
  const nothing = () => undefined;
  const listener = { state: (now: string) => void states.push(now), opened: nothing, event: nothing, binary: nothing, isRefused: () => Promise.resolve(false) };
  new Connection('ws://here', listener).open();
  FakeSocket.all[0].onopen();
  FakeSocket.all[0].onclose();
  await vi.runAllTimersAsync();
  FakeSocket.all[1].onclose();
  await vi.runAllTimersAsync();
  FakeSocket.all[2].onopen();
  expect(states).toEqual(['connecting', 'open', 'lost', 'lost', 'open']);
});

// SPDX-License-Identifier: GPL-3.0-or-later
// One WebSocket to the server. It asks with numbered requests, and mends itself when the line is cut.

import { decode, type Beams, type Solution } from './binary';
import type { Answer, SaveConflict, ServerEvent } from './messages';
import type { AnswerTo, More, RequestName } from './requests';
import { W } from '../words';

export type LineState = 'connecting' | 'open' | 'lost' | 'refused';

export interface Listener {
  state(state: LineState): void;
  event(event: ServerEvent): void;
  binary(message: Beams | Solution): void;
  /** Called after every (re)connection, before anything else is asked. */
  opened(): void;
  /** Whether a server answers but refuses this page: then no connection is tried again. */
  isRefused(): Promise<boolean>;
}

/** The server's refusal, in its own words. */
export class Refusal extends Error {
  constructor(
    words: string,
    readonly conflict?: SaveConflict,
  ) {
    super(words);
  }
}

interface Waiting {
  resolve(answer: never): void;
  reject(error: Error): void;
}

const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 4000;

export class Connection {
  private socket: WebSocket | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private nextId = 1;
  private pause = FIRST_PAUSE_MS;

  constructor(
    private readonly address: string,
    private readonly listener: Listener,
  ) {}

  open(): void {
    this.listener.state('connecting');
    this.connect();
  }

  private connect(): void {
    const socket = new WebSocket(this.address);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      this.pause = FIRST_PAUSE_MS;
      this.listener.state('open');
      this.listener.opened();
    };
    socket.onmessage = (message: MessageEvent<string | ArrayBuffer>) => this.receive(message.data);
    socket.onclose = () => void this.lost();
    this.socket = socket;
  }

  /** Ask for something. Fails with a Refusal in the server's own words, or when the line is cut before the answer. */
  ask<Name extends RequestName>(what: Name, ...[says]: More<Name>): Promise<AnswerTo<Name>> {
    if (this.socket?.readyState !== WebSocket.OPEN) {
      return Promise.reject(new Error(W.line.unreachable));
    }
    const id = this.nextId++;
    this.socket.send(JSON.stringify({ id, do: what, ...says }));
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve: resolve as (answer: never) => void, reject }));
  }

  cut(): void {
    this.socket?.close();
  }

  private receive(data: string | ArrayBuffer): void {
    if (typeof data !== 'string') {
      this.listener.binary(decode(data));
      return;
    }
    const message = JSON.parse(data) as Answer | ServerEvent;
    if ('event' in message) this.listener.event(message);
    else this.settle(message);
  }

  private settle(answer: Answer): void {
    const waiting = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    if (answer.ok) waiting?.resolve(answer as never);
    else waiting?.reject(new Refusal(answer.error, answer.conflict));
  }

  private async lost(): Promise<void> {
    this.listener.state('lost');
    for (const waiting of this.waiting.values()) waiting.reject(new Error(W.line.cut));
    this.waiting.clear();
    if (await this.listener.isRefused()) return this.listener.state('refused');
    setTimeout(() => this.connect(), this.pause); // `lost` stays until the line is open: its notice does not flicker
    this.pause = Math.min(2 * this.pause, LONGEST_PAUSE_MS);
  }
}

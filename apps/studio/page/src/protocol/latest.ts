// SPDX-License-Identifier: GPL-3.0-or-later

/** Sends the newest of a stream of values: one at a time, the next only when the last was answered; what was overtaken is never sent. */
export class Latest<T> {
  private value: { newest: T } | null = null;
  private busy = false;

  constructor(private readonly send: (value: T) => Promise<unknown>) {}

  push(value: T): void {
    this.value = { newest: value };
    if (!this.busy) void this.run();
  }

  private async run(): Promise<void> {
    this.busy = true;
    while (this.value) {
      const { newest } = this.value;
      this.value = null;
      try {
        await this.send(newest);
      } catch {
        // The sender tells people what went wrong; the stream goes on with the next value.
      }
    }
    this.busy = false;
  }
}

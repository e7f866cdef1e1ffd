import type { ErrorKind } from "./gpu_tables.js";

/** What went wrong, as one sentence with the value and the limit; `kind` is what a program may act on. */
export class WeftError extends Error {
  override readonly name = "WeftError";
  constructor(readonly kind: ErrorKind, message: string) {
    super(message);
  }
}

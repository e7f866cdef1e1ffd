import { expect } from "vitest";
import { WeftError } from "weft-cloth";

/** The error of what must fail. */
export const failure = (promise: Promise<unknown>): Promise<WeftError> =>
  promise.then(() => {
    throw new Error("It did not fail.");
  }, (error: unknown) => {
    expect(error).toBeInstanceOf(WeftError);
    return error as WeftError;
  });

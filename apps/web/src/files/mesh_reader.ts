// Asks a worker what is in a file, and ends it when it has answered or when its time is up.
import { MOST_SECONDS } from "./limits.js";
import type { Answer, Request } from "./mesh_worker.js";

type Read<Kind extends Request["kind"]> = Extract<Answer, { kind: Kind }>;

/** `what` names the file in the sentence of a failure. */
export function readApart<Kind extends Request["kind"]>(what: string,
  request: Request & { kind: Kind }): Promise<Read<Kind>> {
  const worker = new Worker(new URL("./mesh_worker.ts", import.meta.url), { type: "module" });
  return new Promise<Read<Kind>>((resolve, reject) => {
    const timer = setTimeout(() =>
      reject(new Error(
        `${what} was given up: reading it took longer than the limit of ${MOST_SECONDS} s.`,
      )), MOST_SECONDS * 1000);
    worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => {
      clearTimeout(timer);
      if (data.kind === "failed") reject(new Error(data.sentence));
      else resolve(data as Read<Kind>);
    });
    worker.addEventListener("error", (event) => {
      event.preventDefault(); // the page reports it
      clearTimeout(timer);
      reject(
        new Error(`${what} could not be read: the worker has stopped${event.message ? ` (${event.message})` : ""}.`),
      );
    });
    worker.postMessage(request);
  }).finally(() => worker.terminate());
}

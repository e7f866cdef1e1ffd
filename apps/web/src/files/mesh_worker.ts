// Reads a visitor's files apart from the page, with a module of the core of its own: a file that takes long or ends the
// module ends this worker, and the page goes on. Nothing is fetched here but the core.
import { checkScene, readMesh, type MeshFile, type SceneSize } from "weft-cloth";
import { megabytes, MOST_BYTES } from "./limits.js";

export type Request =
  | { kind: "mesh"; file: File }
  /** `files` by the name that the scene gives them; `models`: those that the page has itself. */
  | { kind: "scene"; scene: string; files: Record<string, File>; models: Record<string, ArrayBuffer> };

export type Answer =
  | { kind: "mesh"; mesh: MeshFile }
  /** The files as PLY, by the same names. */
  | { kind: "scene"; size: SceneSize; meshes: Record<string, Uint8Array<ArrayBuffer>> }
  | { kind: "failed"; sentence: string };

/** The bytes of a file, unpacked where they are gzip data, and its name without .gz. */
async function bytesOf(file: File): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> }> {
  const head = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  if (head[0] !== 0x1f || head[1] !== 0x8b) return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let size = 0;
  const reader = file.stream().pipeThrough(new DecompressionStream("gzip")).getReader();
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new Error(`${file.name}: its gzip data are broken.`);
    });
    if (done) break;
    size += value.length;
    if (size > MOST_BYTES) {
      await reader.cancel();
      throw new Error(`${file.name} unpacks to more than the limit of ${megabytes(MOST_BYTES)}.`);
    }
    pieces.push(value);
  }
  return { name: file.name.replace(/\.gz$/i, ""), bytes: new Uint8Array(await new Blob(pieces).arrayBuffer()) };
}

async function readScene({ scene, files, models }: Request & { kind: "scene" }): Promise<Answer> {
  const brought: Record<string, Uint8Array<ArrayBuffer>> = {};
  for (const [name, file] of Object.entries(files)) brought[name] = (await bytesOf(file)).bytes;
  const size = await checkScene(scene, { ...models, ...brought });
  const meshes: Record<string, Uint8Array<ArrayBuffer>> = {};
  for (const [name, bytes] of Object.entries(brought)) meshes[name] = (await readMesh(plyWhereBare(name), bytes)).ply;
  return { kind: "scene", size, meshes };
}

/** A name without an end is that of a PLY file, as in the core. */
const plyWhereBare = (name: string): string => (name.includes(".") ? name : `${name}.ply`);

async function answer(request: Request): Promise<Answer> {
  if (request.kind === "scene") return readScene(request);
  const { name, bytes } = await bytesOf(request.file);
  return { kind: "mesh", mesh: await readMesh(name, bytes, { cleaned: true }) };
}

addEventListener("message", (event: MessageEvent<Request>) => {
  answer(event.data).then(
    (done) => postMessage(done),
    (reason: unknown) =>
      postMessage({ kind: "failed", sentence: reason instanceof Error ? reason.message : String(reason) }),
  );
});

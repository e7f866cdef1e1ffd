// Exports: shapes from the core, the picture from the canvas.
import type { World } from "weft-cloth";
import { OWN, type LoadedScene } from "../scenes.js";

const TYPES = { obj: "model/obj", ply: "application/octet-stream", glb: "model/gltf-binary" } as const;
export type Shape = keyof typeof TYPES;
export const SHAPES = Object.keys(TYPES) as Shape[];

/** The name of a file: the scene and the frame, as breeze-00120.obj. */
export function fileName({ state, title }: LoadedScene, frame: number, end: string): string {
  const name = state.scene === OWN ?
    title.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "").toLowerCase() :
    state.scene;
  return `${name || OWN}-${String(frame).padStart(5, "0")}.${end}`;
}

export function download(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000); // the browser may ask the user first
}

export async function saveShape(world: World, scene: LoadedScene, shape: Shape): Promise<string> {
  const bytes = await world.exportMesh(shape);
  const name = fileName(scene, world.statistics.frames, shape);
  download(name, new Blob([bytes], { type: TYPES[shape] }));
  return name;
}

/** A WebGPU canvas keeps its picture only until the task that drew it ends, so the next one is taken as it is drawn. */
export async function savePicture(world: World, scene: LoadedScene, canvas: HTMLCanvasElement): Promise<string> {
  let frame = 0;
  const picture = await new Promise<Blob | null>((resolve) => {
    const stop = world.on("frame", ({ frames }) => {
      stop();
      frame = frames;
      canvas.toBlob(resolve, "image/png");
    });
    world.redraw();
  });
  if (!picture) throw new Error(`The picture of ${canvas.width} × ${canvas.height} pixels could not be made.`);
  const name = fileName(scene, frame, "png");
  download(name, picture);
  return name;
}

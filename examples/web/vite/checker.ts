// A worker that reads the scene first, without a GPU: a file of a visitor's cannot hold up the page.
import { checkScene, type Scene } from "weft-cloth";

self.onmessage = async ({ data }: MessageEvent<Scene>) => {
  self.postMessage(await checkScene(data).then(({ nodes }) => `${nodes} nodes`, ({ message }: Error) => message));
};

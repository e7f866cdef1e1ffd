// A worker that reads the scene first, without a GPU: a file of a visitor's cannot hold up the page.
import { checkScene } from "weft-cloth";

self.onmessage = async ({ data }) => {
  self.postMessage(await checkScene(data).then(({ nodes }) => `${nodes} nodes`, ({ message }) => message));
};

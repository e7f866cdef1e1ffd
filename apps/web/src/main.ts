import type { World } from "weft";
import { followSize, setFirstSize } from "./canvas_size.js";
import { Controls } from "./controls.js";
import { element } from "./elements.js";
import { showFallback } from "./fallback.js";
import { Files } from "./files/files.js";
import { Notice } from "./notice.js";
import { Player } from "./player.js";
import { Pointer } from "./pointer.js";
import { addressOf, choiceOf, type Choice } from "./scenes.js";
import { Status } from "./status.js";
import { missingDevice, missingSupport } from "./support.js";

/** `window.weft`, for tests and the browser's console. `ready` rejects where the page cannot open a world. */
export interface PageHandle {
  readonly world: World | null;
  readonly ready: Promise<World>;
}

const canvas = element("canvas", HTMLCanvasElement);
const notice = new Notice();
const status = new Status();
const player = new Player(canvas, {
  opening(sentence) {
    pointer.forget();
    controls.opening();
    notice.wait(sentence);
  },
  opened(scene, info) {
    controls.opened(scene);
    status.showFacts(info);
    notice.wait(null);
    notice.announce(`${scene.title}: ${info.nodes} nodes.`);
    history.replaceState(null, "", addressOf(scene.choice));
  },
  empty() {
    controls.empty();
    status.showFacts(null);
    notice.wait(null);
  },
  playing(on) {
    controls.playing(on);
    status.restart();
    if (on && player.live) notice.clear(); // it has been read
    notice.announce(on ? "Playing." : "Paused.");
  },
  viewed: (view) => controls.viewed(view),
  frame: (statistics) => status.frame(performance.now(), statistics),
  said: (sentence) => notice.say(sentence, "plain"),
  failed: (sentence) => notice.say(sentence),
});
const controls = new Controls(player, (choice) => void show(choice));
const pointer = new Pointer(canvas, player);
new Files(player, notice, canvas, show);

async function show(choice: Choice): Promise<void> {
  notice.clear();
  try {
    await player.open(choice);
  } catch {
    const missing = await missingDevice(); // an input that fails, or no device to try it on?
    if (missing) showFallback(missing);
  }
}

async function start(): Promise<World> {
  const missing = await missingSupport();
  if (missing) {
    showFallback(missing);
    throw new Error(missing.cause);
  }
  setFirstSize(canvas);
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  await show(choiceOf(location.href));
  if (document.body.classList.contains("without-gpu")) throw new Error("There is no WebGPU device.");
  followSize(canvas, (width, height) => player.resize(width, height));
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) pointer.cancel();
    player.setHidden(document.hidden);
  });
  player.setHidden(document.hidden);
  if (!still) player.play(true);
  else if (player.live) notice.say("Your system asks for less motion, so the cloth waits until you press Play.", "plain");
  if (!player.world) throw new Error("The first scene could not be opened.");
  return player.world;
}

const ready = start();
ready.catch(() => undefined); // said on the page already
const handle: PageHandle = { get world() { return player.world; }, ready };
Object.assign(window, { weft: handle });

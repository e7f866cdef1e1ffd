import { catalog, VIEWS, type World } from "weft-cloth";
import { Address, linkTo } from "./address.js";
import { followSize, setFirstSize } from "./canvas_size.js";
import { Gallery } from "./controls/gallery.js";
import { Panel } from "./controls/panel.js";
import { Pins } from "./controls/pins.js";
import { Theme } from "./controls/theme.js";
import { element } from "./elements.js";
import { showFallback } from "./fallback.js";
import { Files } from "./files/files.js";
import { adapterLimits } from "./memory.js";
import { Notice, type Offer } from "./notice.js";
import { Player } from "./player.js";
import type { PlayerEvents } from "./player_events.js";
import { Pointer } from "./pointer.js";
import { SCENES } from "./scenes.js";
import { plain, withKey, type PageState } from "./state/page_state.js";
import { leftOut } from "./state/pin_text.js";
import { solversOf, SUBSTEPS } from "./state/parameters.js";
import { read } from "./state/url_state.js";
import { missingDevice, missingSupport } from "./support.js";

/** `window.weft`, for tests and the browser's console. `ready` rejects where the page cannot open a world. */
export interface PageHandle {
  readonly world: World | null;
  readonly state: PageState | null;
  /** The world on the right of a comparison. */
  readonly other: World | null;
  /** Nodes that are pinned. */
  readonly pins: readonly number[];
  readonly ready: Promise<World>;
}

const MOST_NODES = 16384; // along a side, as scenes may have
const CAMERA_CALM = 400; // how often it is looked at where the camera is [ms]

const notice = new Notice();
const address = new Address();
const theme = new Theme(); // without WebGPU too
let page: { player: Player; pins: Pins } | null = null;

/** All that needs WebGPU: the player and what stands around it. */
async function build(): Promise<{ player: Player; pins: Pins; refused: string | null }> {
  const canvas = element("canvas", HTMLCanvasElement);
  setFirstSize(canvas);
  const [offers, limits] = await Promise.all([catalog(), adapterLimits()]);
  const asked = () =>
    read(location.href, { schema: offers.schema, solvers: solversOf(offers), scenes: SCENES.map(({ name }) => name),
      view: VIEWS[0], mostNodes: MOST_NODES, mostPins: offers.mostGrabs - 1 });
  const { state, refused } = asked();
  let cameraAt = 0;
  let remedy: Offer | null = null; // where the step is unstable
  let greeting = location.search === ""; // while nothing has been chosen, the address names nothing
  const events: PlayerEvents = {
    opening(sentence) {
      remedy = null;
      pointer.forget();
      pins.forget();
      panel.opening();
      notice.wait(sentence);
    },
    opened(scene, info) {
      panel.opened(scene, info);
      gallery.mark(scene.state.scene);
      remedy = info.unstableStep === null ?
        null :
        { label: "Use “auto”", act: () => void show(player, withKey(player.noteCamera(), SUBSTEPS, "auto")) };
      if (info.unstableStep !== null) notice.say(info.unstableStep, "warning", remedy);
      notice.wait(null);
      notice.announce(`${scene.title}: ${info.nodes} nodes.`);
    },
    preparing: (sentence) => notice.wait(sentence),
    compared: () => panel.compared(),
    empty() {
      panel.empty();
      gallery.mark(null);
      notice.wait(null);
    },
    playing(on) {
      panel.playing(on);
      if (on && player.live) notice.clearError(); // it has been read
      notice.announce(on ? "Playing." : "Paused.");
    },
    viewed: (view) => panel.viewed(view),
    changed(state) {
      if (player.loaded) panel.changed(player.loaded, state);
      if (!greeting) address.show(state);
    },
    rested: () => pins.forget(),
    wentBack: () => pointer.forget(),
    held: (held) => pins.take(held),
    frame(statistics, host) {
      const now = performance.now();
      panel.frame(now, statistics, host);
      pins.draw();
      if (now - cameraAt < CAMERA_CALM) return;
      cameraAt = now;
      setTimeout(() => player.noteCamera(), CAMERA_CALM); // where it has come to by then
    },
    said: (sentence) => notice.say(sentence, "plain"),
    failed: (sentence) => notice.say(sentence, "error", remedy),
  };
  const player = new Player(canvas, offers, limits, state, events);
  const say = (sentence: string) => notice.say(sentence, "plain");
  const pins = new Pins(canvas, player, offers.mostGrabs, say);
  const pointer = new Pointer(canvas, player, pins);
  const gallery = new Gallery((scene) => void show(player, plain(scene, player.state.view)));
  const go = (wanted: PageState) => {
    gallery.close();
    return show(player, wanted);
  };
  gallery.onChange = () => {
    if (!gallery.shown && greeting) {
      greeting = false;
      address.show(player.state);
    }
    see();
  };
  const panel = new Panel({ canvas, catalog: offers, limits, player, pins, theme, gallery, say,
    open: (wanted) => void go(wanted), link: () => {
      pins.note();
      return { address: linkTo(player.noteCamera()), but: leftOut(player.state.pins) };
    } });
  new Files(player, notice, canvas, go);
  followSize(canvas, async (width, height) => {
    await player.resize(width, height);
    pins.draw();
    panel.resized();
  });
  window.addEventListener("popstate", (event) => {
    const { state: named, refused: fault } = asked();
    const wanted = address.entered(event.state, named);
    if (!wanted) return;
    void address.follow(async () => {
      if (await go(wanted) && fault !== null) notice.say(fault);
    }, () => player.state);
  });
  const see = () => player.setHidden(document.hidden || gallery.shown);
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) pointer.cancel();
    see();
  });
  if (greeting) gallery.greet();
  see();
  return { player, pins, refused };
}

/** Opens a scene; false where there is none then, and it has been said why. */
async function show(player: Player, state: PageState): Promise<boolean> {
  notice.clear();
  try {
    await player.open(state);
    return true;
  } catch {
    const missing = await missingDevice(); // an input that fails, or no device to try it on?
    if (missing) showFallback(missing);
    return false;
  }
}

async function start(): Promise<World> {
  const missing = await missingSupport();
  if (missing) {
    showFallback(missing);
    throw new Error(missing.cause);
  }
  const { player, pins, refused } = await build();
  page = { player, pins };
  const asked = player.state;
  const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!still) player.play(true); // as soon as there is something to play
  let sentence = refused;
  if (!(await show(player, asked)) && Object.keys(asked.set).length + Number(asked.nodes !== null) > 0) {
    sentence = notice.text; // why it could not be opened as the address asks
    await show(player, plain(asked.scene, asked.view));
  }
  if (document.body.classList.contains("without-gpu")) throw new Error("There is no WebGPU device.");
  if (still && player.live && notice.text === null)
    notice.say("Your system asks for less motion, so the cloth waits until you press Play.", "plain");
  if (sentence !== null) notice.say(sentence);
  if (!player.world) throw new Error("The first scene could not be opened.");
  return player.world;
}

const ready = start();
ready.catch(() => undefined); // said on the page already
const handle: PageHandle = {
  get world() {
    return page?.player.world ?? null;
  },
  get state() {
    return page?.player.state ?? null;
  },
  get other() {
    return page?.player.beside.world ?? null;
  },
  get pins() {
    return page?.pins.pinned.map(({ node }) => node) ?? [];
  },
  ready,
};
Object.assign(window, { weft: handle });

// The keys that do what the panel does; docs/web.md and the help list them.
import { VIEWS } from "weft-cloth";
import type { Player } from "../player.js";
import type { Gallery } from "./gallery.js";
import type { Help } from "./help.js";
import type { Pins } from "./pins.js";
import type { Probes } from "./probes.js";
import type { Theme } from "./theme.js";
import type { Views } from "./views.js";

interface Parts {
  readonly player: Player;
  readonly views: Views;
  readonly pins: Pins;
  readonly probes: Probes;
  readonly help: Help;
  readonly theme: Theme;
  readonly gallery: Gallery;
}

export function followKeys(parts: Parts): void {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.repeat || parts.help.shown || !parts.help.keysOn)
      return;
    const target = event.target instanceof Element ? event.target : document.body;
    if (target.closest("select, input[type=number]")) return; // letters and digits choose there
    // The space bar presses the control that has the focus.
    if (event.key === " " && target.closest("button, summary, a, input:not([type=range])")) return;
    const action = pageAction(event.key, parts) ?? (parts.player.live && sceneAction(event, parts));
    if (!action) return;
    event.preventDefault();
    action();
  });
}

function pageAction(key: string, { help, theme, gallery }: Parts): (() => void) | null {
  switch (key.toLowerCase()) {
    case "?":
      return () => help.open();
    case "t":
      return () => theme.toggle();
    case "g":
      return () => gallery.toggle();
    default:
      return null;
  }
}

function sceneAction(event: KeyboardEvent, { player, views, pins, probes }: Parts): (() => void) | null {
  const key = event.key.toLowerCase();
  const view = VIEWS[Number(key) - 1];
  if (view) return () => views.choose(view);
  switch (key) {
    case " ":
      return () => player.play(!player.playing);
    case ".":
      return () => void player.step();
    case "r":
      return () => void player.reset();
    case "f":
      return () => void player.resetCamera();
    case "x":
      return () => views.toggleWireframe();
    case "p":
      return () => void (event.shiftKey ? pins.toggleMiddle() : pins.toggleUnderPointer());
    case "m":
      return () => void probes.toggleUnderPointer();
    case "u":
      return () => void pins.removeAll();
    default:
      return null;
  }
}

// The page's address follows its state, so that a reload or a copied link opens the same.
import { VIEWS } from "weft-cloth";
import { OWN } from "./scenes.js";
import type { PageState } from "./state/page_state.js";
import { write } from "./state/url_state.js";

const CALM = 300; // browsers refuse to replace an address too often [ms]

/** Nobody else has a scene that the visitor has brought. */
function addressOf(state: PageState): string { return state.scene === OWN ? location.pathname : write(state, VIEWS[0]); }

export class Address {
  private waiting: ReturnType<typeof setTimeout> | undefined;

  show(state: PageState): void {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => history.replaceState(null, "", addressOf(state)), CALM);
  }
}

/** The address that opens the page in this state. */
export function linkTo(state: PageState): string { return new URL(addressOf(state), location.href).href; }

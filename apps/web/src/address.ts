// The page's address follows its state, so that a reload or a copied link opens the same. Each scene is an entry of the
// browser's history, so that Back returns to the scene before.
import { VIEWS } from "weft-cloth";
import { OWN, ownScene } from "./scenes.js";
import type { PageState } from "./state/page_state.js";
import { write } from "./state/url_state.js";

const CALM = 300; // browsers refuse to replace an address too often [ms]

/** Nobody else has a scene that the visitor has brought. */
function addressOf(state: PageState): string {
  return state.scene === OWN ? location.pathname : write(state, VIEWS[0]);
}

export class Address {
  private waiting: ReturnType<typeof setTimeout> | undefined;
  private shown: PageState | null = null; // what the entry is to say, at once or soon
  private search = location.search; // what it says
  private going = 0; // to how many entries the browser has gone that are not shown yet

  /** The state has changed. */
  show(state: PageState): void {
    if (this.going > 0) return; // `follow` ends with what has come of it
    clearTimeout(this.waiting);
    const before = this.shown;
    this.shown = state;
    if (before && before.scene !== state.scene) {
      this.put("replaceState", before);
      this.put("pushState", state);
    } else {
      this.waiting = setTimeout(() => this.put("replaceState", state), CALM);
    }
  }

  private put(how: "pushState" | "replaceState", state: PageState): void {
    // An address does not say what a scene of the visitor's own is, or what is changed in it.
    history[how](state.scene === OWN ? state : null, "", addressOf(state));
    this.search = location.search;
  }

  /** What the entry asks for to which the browser has gone; null: what is shown. `asked`: by its address. */
  entered(kept: unknown, asked: PageState): PageState | null {
    if (location.search === this.search) return null; // a link within the page
    this.search = location.search;
    return kept !== null && ownScene() ? (kept as PageState) : asked;
  }

  /** While `open` shows an entry, what is still shown from before is not written to it. */
  async follow(open: () => Promise<unknown>, shown: () => PageState): Promise<void> {
    clearTimeout(this.waiting);
    this.going += 1;
    await open();
    this.going -= 1;
    this.shown = null; // the entry is there
    this.show(shown());
  }
}

/** The address that opens the page in this state. */
export function linkTo(state: PageState): string {
  return new URL(addressOf(state), location.href).href;
}

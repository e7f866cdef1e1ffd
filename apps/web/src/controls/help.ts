// The dialog that lists what pointer and keys do. The browser keeps the focus in it, and gives it back.
import { VIEWS } from "weft-cloth";
import { button, element, input } from "../elements.js";

export class Help {
  private readonly dialog = element("help", HTMLDialogElement);

  constructor() {
    element("view-keys", HTMLElement).textContent = `1 to ${VIEWS.length}`;
    button("help-open").addEventListener("click", () => this.open());
    button("help-close").addEventListener("click", () => this.dialog.close());
    this.dialog.addEventListener("click", (event) => { // beside its content: on the backdrop
      if (event.target === this.dialog) this.dialog.close();
    });
  }

  get shown(): boolean {
    return this.dialog.open;
  }
  /** Whether the page's keys are in use. */
  get keysOn(): boolean {
    return input("shortcuts").checked;
  }

  open(): void {
    this.dialog.showModal();
  }
}

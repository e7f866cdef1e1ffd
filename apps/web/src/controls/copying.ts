// All that the panel says, and the page's address, for the clipboard.
import { button } from "../elements.js";

export interface Copied {
  /** The address that opens the page as it is. */
  link(): string;
  readings(): unknown;
}

export function offerCopies({ link, readings }: Copied, say: (sentence: string) => void): void {
  const copy = async (what: string, text: string) => {
    try {
      await navigator.clipboard.writeText(text);
      say(`${what} is copied.`);
    } catch {
      say(`The browser does not let this page write to the clipboard, so ${what.toLowerCase()} could not be copied.`);
    }
  };
  button("copy-link").addEventListener("click", () => void copy("The link", link()));
  button("copy-readings").addEventListener("click",
    () => void copy("The list of readings", `${JSON.stringify(readings(), null, 2)}\n`));
}

// All that the panel says, and the page's address, for the clipboard.
import { button } from "../elements.js";

export interface Copied {
  /** The address that opens the page as it is, but for what a sentence says. */
  link(): { readonly address: string; readonly but: string | null };
  readings(): unknown;
}

export function offerCopies({ link, readings }: Copied, say: (sentence: string) => void): void {
  const copy = async (what: string, text: string, but: string | null = null) => {
    try {
      await navigator.clipboard.writeText(text);
      say([`${what} is copied.`, ...(but === null ? [] : [but])].join(" "));
    } catch {
      say(`The browser does not let this page write to the clipboard, so ${what.toLowerCase()} could not be copied.`);
    }
  };
  button("copy-link").addEventListener("click", () => {
    const { address, but } = link();
    void copy("The link", address, but);
  });
  button("copy-readings").addEventListener("click",
    () => void copy("The list of readings", `${JSON.stringify(readings(), null, 2)}\n`));
}

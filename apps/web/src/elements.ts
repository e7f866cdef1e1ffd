/** The element of index.html with this id. Its absence or another type is a mistake of ours, so it throws. */
export function element<T extends HTMLElement | SVGElement>(id: string, type: new() => T): T {
  const found = document.getElementById(id) as Element | null;
  if (!(found instanceof type)) throw new Error(`index.html has no ${type.name} with the id ${id}.`);
  return found;
}

export const button = (id: string): HTMLButtonElement => element(id, HTMLButtonElement);
export const select = (id: string): HTMLSelectElement => element(id, HTMLSelectElement);
export const input = (id: string): HTMLInputElement => element(id, HTMLInputElement);

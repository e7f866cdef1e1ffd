// Asks what a mesh is to be, and how large.
import type { MeshFile } from "weft-cloth";
import { button, element, input } from "../elements.js";
import { box, count, LENGTH, MOST_CLOTH_NODES, MOST_OBSTACLE_TRIANGLES } from "./limits.js";
import { sides, type Role } from "./own_scene.js";

export interface Use {
  role: Role;
  /** Of the longest side [m]. */
  length: number;
}

const counted = (number: number, one: string, many: string): string => `${count(number)} ${number === 1 ? one : many}`;

export class MeshDialog {
  private readonly dialog = element("mesh-dialog", HTMLDialogElement);
  private readonly length = input("mesh-length");
  private readonly roles: Readonly<Record<Role, HTMLInputElement>> = {
    obstacle: input("mesh-obstacle"),
    cloth: input("mesh-cloth"),
  };
  private mesh: MeshFile | null = null;
  private answer: ((use: Use | null) => void) | null = null;

  constructor() {
    Object.assign(this.length, { min: String(LENGTH.least), max: String(LENGTH.most) });
    this.length.addEventListener("input", () => this.showSize());
    element("mesh-form", HTMLFormElement).addEventListener("submit", (event) => {
      event.preventDefault(); // the page's policy allows no form to be sent
      if (this.fault() !== null) return this.length.focus();
      this.close({ role: this.roles.cloth.checked ? "cloth" : "obstacle", length: Number(this.length.value) });
    });
    button("mesh-cancel").addEventListener("click", () => this.close(null));
    this.dialog.addEventListener("cancel", () => this.close(null)); // Escape
    this.dialog.addEventListener("keydown", (event) => event.stopPropagation()); // digits are a length here, not views
  }

  /** Null: the mesh is not to be opened. */
  ask(name: string, mesh: MeshFile): Promise<Use | null> {
    this.close(null);
    this.mesh = mesh;
    element("mesh-title", HTMLHeadingElement).textContent = name;
    const left = mesh.dropped > 0 ? ` ${counted(mesh.dropped, "triangle", "triangles")} without area left out.` : "";
    element("mesh-facts", HTMLParagraphElement).textContent =
      `${counted(mesh.vertices, "vertex", "vertices")}, ${counted(mesh.triangles, "triangle", "triangles")}, ` +
      `${box(sides(mesh))} in the file's unit.${left}`;
    const fits = { cloth: mesh.vertices <= MOST_CLOTH_NODES, obstacle: mesh.triangles <= MOST_OBSTACLE_TRIANGLES };
    for (const role of ["obstacle", "cloth"] as const) this.roles[role].disabled = !fits[role];
    this.roles[fits.obstacle ? "obstacle" : "cloth"].checked = true;
    element("mesh-limit", HTMLParagraphElement).textContent = !fits.cloth ?
      `A cloth may have ${count(MOST_CLOTH_NODES)} vertices at most.` :
      !fits.obstacle ?
      `An obstacle may have ${count(MOST_OBSTACLE_TRIANGLES)} triangles at most.` :
      "";
    this.length.value = String(LENGTH.first);
    this.showSize();
    this.dialog.showModal();
    return new Promise((resolve) => {
      this.answer = resolve;
    });
  }

  private close(use: Use | null): void {
    if (this.dialog.open) this.dialog.close();
    this.answer?.(use);
    this.answer = null;
  }

  private fault(): string | null {
    const length = Number(this.length.value);
    if (this.length.value !== "" && length >= LENGTH.least && length <= LENGTH.most) return null;
    const given = this.length.value === "" ? "missing" : `${length} m`;
    return `The length is ${given}; it must be from ${LENGTH.least} to ${LENGTH.most} m.`;
  }

  private showSize(): void {
    const fault = this.fault();
    const size = element("mesh-size", HTMLParagraphElement);
    this.length.setAttribute("aria-invalid", String(fault !== null));
    if (fault !== null || !this.mesh) return void (size.textContent = fault ?? "");
    const all = sides(this.mesh);
    const scale = Number(this.length.value) / Math.max(...all);
    size.textContent = `${box(all.map((side) => side * scale))} m`;
  }
}

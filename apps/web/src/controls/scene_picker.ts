// Which scene, how fine, and by which methods. What there is of each comes from the page's list and the core's schema.
import { schemaOf, type Catalog, type WorldInfo } from "weft-cloth";
import { element, select } from "../elements.js";
import { inBytes, type Limits } from "../memory.js";
import { SCENE_GROUPS, type LoadedScene } from "../scenes.js";
import { choicesOf } from "../state/limits.js";
import { plain, withKey, type PageState } from "../state/page_state.js";
import { CONTACT_METHOD, FORMULATION, ownMethod, SOLVER, solversOf, withMethod,
  withNodes } from "../state/parameters.js";
import { resolutionsOf } from "./resolutions.js";

/** What the schema's words are called here; one that is not, by itself. */
const NAMES: Readonly<Record<string, string>> = {
  node_centric: "Node-centric (gather)",
  spring_centric: "Spring-centric (scatter)",
  spring_blocks: "Spring blocks (scatter, summed in groups)",
  none: "None",
  proximity: "Proximity",
  bvh: "BVH (the paper's pairs, by a tree)",
  paper: "Paper (all pairs)",
};

/** What a contact method costs or leaves out. */
const REMARKS: Readonly<Record<string, string>> = {
  none: "Nothing holds the cloth up: it falls through everything.",
  bvh: "Cloth meets obstacles, not itself.",
  paper: "Tests every cloth triangle against every triangle of the obstacle in every step: slow, for comparison.",
};

/** Whether the scene's solver has formulations to choose from. */
const hasFormulations = (scene: LoadedScene): boolean =>
  scene.methods.some(({ kind, memory }) => kind === scene.now(SOLVER) && !("" in memory));

export class ScenePicker {
  private readonly scene = select("scene");
  private readonly resolution = select("resolution");
  private readonly solver = select("solver");
  private ownSolver = ""; // the scene's, or what a fabric has in its place
  private readonly methods = [[select("formulation"), FORMULATION], [select("contact"), CONTACT_METHOD]] as const;

  constructor(catalog: Catalog, private readonly limits: Limits, current: () => PageState,
    open: (state: PageState) => void) {
    this.scene.replaceChildren(...SCENE_GROUPS.map(({ title, scenes }) => {
      const group = document.createElement("optgroup");
      group.label = title;
      group.append(...scenes.map((scene) => new Option(scene.title, scene.name)));
      return group;
    }));
    for (const [list, key] of this.methods) {
      const words = choicesOf(schemaOf(catalog.schema, key) ?? {});
      list.replaceChildren(...words.map((word) => new Option(NAMES[word] ?? word, word)));
      list.addEventListener("change", () => open(withKey(current(), key, list.value)));
    }
    this.solver.replaceChildren(...solversOf(catalog).map((word) => new Option(word, word)));
    this.solver.addEventListener("change", () => open(withMethod(current(), this.chosenMethod())));
    this.scene.addEventListener("change", () => open(plain(this.scene.value, current().view)));
    this.resolution.addEventListener("change", () => open(withNodes(current(), Number(this.resolution.value))));
  }

  /** null: the one that holds where none is chosen. */
  private chosenMethod(): string | null {
    return this.solver.value === this.ownSolver ? null : this.solver.value;
  }

  enable(on: boolean): void {
    this.scene.disabled = false; // another choice may replace one that takes long
    for (const list of [this.resolution, this.solver, ...this.methods.map(([list]) => list)]) list.disabled = !on;
  }

  opened(scene: LoadedScene, info: WorldInfo): void {
    this.scene.value = scene.state.scene;
    this.ownSolver = ownMethod(scene, scene.state);
    this.solver.value = String(scene.now(SOLVER));
    for (const [list, key] of this.methods) list.value = String(scene.now(key));
    select("formulation").parentElement!.hidden = !hasFormulations(scene);
    this.fillResolutions(scene);
    element("description", HTMLParagraphElement).textContent = scene.description;
    const method = String(scene.now(CONTACT_METHOD));
    const remark = method === "none" && scene.own(CONTACT_METHOD) === "none" ? "" : REMARKS[method] ?? "";
    const contact = element("contact-remark", HTMLParagraphElement);
    contact.textContent = remark;
    contact.hidden = remark === "";
    const nodes = info.nodes.toLocaleString("en");
    element("memory", HTMLParagraphElement).textContent = `${nodes} nodes: ${inBytes(info.gpuBytes)} on the GPU.`;
  }

  empty(): void {
    this.enable(false);
    // Any choice must count as a change, so none is shown as made.
    this.scene.selectedIndex = -1;
    this.resolution.replaceChildren();
  }

  private fillResolutions(scene: LoadedScene): void {
    const { grid } = scene;
    this.resolution.disabled = grid === null;
    if (!grid) return this.resolution.replaceChildren(new Option("as its mesh has", ""));
    this.resolution.replaceChildren(...resolutionsOf(scene, scene.state.nodes, this.limits));
    this.resolution.value = String(scene.state.nodes ?? grid.usual);
  }
}

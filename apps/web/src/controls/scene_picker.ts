// Which scene, how fine, and by which methods. What there is of each comes from the page's list and the core's schema.
import { schemaOf, type Catalog, type WorldInfo } from "weft-cloth";
import { element, select } from "../elements.js";
import { demand, inBytes, tooLarge, type Limits } from "../memory.js";
import { gridOf, SCENE_GROUPS, type LoadedScene } from "../scenes.js";
import { choicesOf } from "../state/limits.js";
import { plain, withKey, type PageState } from "../state/page_state.js";
import { CONTACT_METHOD, FORMULATION, SOLVER, solversOf, SUBSTEPS } from "../state/parameters.js";

const RESOLUTIONS = [32, 64, 100, 128, 200, 256, 400, 512, 800, 1024, 1600, 2048] as const;

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

  constructor(catalog: Catalog, private readonly limits: Limits, private readonly current: () => PageState,
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
    this.solver.addEventListener("change", () => open(this.solved(this.solver.value)));
    this.scene.addEventListener("change", () => open(plain(this.scene.value, current().view)));
    this.resolution.addEventListener("change", () => open(this.refined(Number(this.resolution.value))));
  }

  /** Another resolution has other nodes, and "auto" chooses its steps again. */
  private refined(nodes: number): PageState {
    return { ...withKey(this.current(), SUBSTEPS, null), nodes };
  }

  /** Another method has other settings and other steps. */
  private solved(kind: string): PageState {
    return withKey(withKey(withKey(this.current(), FORMULATION, null), SUBSTEPS, null), SOLVER,
      kind === this.ownSolver ? null : kind);
  }

  enable(on: boolean): void {
    this.scene.disabled = false; // another choice may replace one that takes long
    for (const list of [this.resolution, this.solver, ...this.methods.map(([list]) => list)]) list.disabled = !on;
  }

  opened(scene: LoadedScene, info: WorldInfo): void {
    this.scene.value = scene.state.scene;
    this.ownSolver = String(scene.valueOf(SOLVER, withKey(scene.state, SOLVER, null).set));
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
    const { grid, copies } = scene;
    this.resolution.disabled = grid === null;
    if (!grid) return this.resolution.replaceChildren(new Option("as its mesh has", ""));
    const { own, usual } = grid;
    const chosen = scene.state.nodes ?? usual;
    const counts = [...new Set([...RESOLUTIONS, usual, Math.max(...own), chosen])].sort((a, b) => a - b);
    this.resolution.replaceChildren(...counts.map((count) => {
      const [along, down] = gridOf(own, count);
      const asked = demand(along * down * copies, scene);
      const fault = tooLarge(asked, this.limits);
      const option = new Option(
        `${along} × ${down}${copies > 1 ? ` × ${copies} sheets` : ""}, ${
          fault ? "too large" : `about ${inBytes(asked.gpu)}`
        }`,
        String(count),
        false,
        count === chosen,
      );
      option.disabled = fault !== null;
      return option;
    }));
  }
}

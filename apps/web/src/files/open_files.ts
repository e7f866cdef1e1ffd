// From files to a scene on the page: which of them is what, read apart, asked about, opened.
import { meshNames } from "weft-cloth";
import { select } from "../elements.js";
import type { Notice } from "../notice.js";
import type { Player } from "../player.js";
import { sentence } from "../sentence.js";
import { fetchModel, keepOwnScene, OWN, ownScene, type OwnScene } from "../scenes.js";
import { plain, type PageState } from "../state/page_state.js";
import { checkLimit, MOST_BYTES, MOST_CLOTH_NODES, MOST_OBSTACLE_TRIANGLES, MOST_SCENE_BYTES,
  MOST_SCENE_NODES } from "./limits.js";
import { MeshDialog } from "./mesh_dialog.js";
import { readApart } from "./mesh_reader.js";
import { sceneOfJson, sceneOfMesh } from "./own_scene.js";

const isScene = ({ name }: File): boolean => /\.json$/i.test(name);
/** Without folders, packed or not. */
const bare = (path: string): string => path.replace(/^.*[\\/]|\.gz$/gi, "");

export class FileOpener {
  private readonly dialog = new MeshDialog();
  private newest = 0;

  constructor(private readonly player: Player, private readonly notice: Notice,
    private readonly show: (state: PageState) => Promise<unknown>) {}

  /** A mesh, or a scene with the meshes that it names. Failures are reported, and the scene that is shown stays. */
  async open(files: readonly File[]): Promise<void> {
    if (files.length === 0) return;
    const number = ++this.newest;
    this.notice.clear();
    try {
      const own = await this.sceneOf(files, () => number !== this.newest);
      if (own && number === this.newest) await this.showOwn(own);
    } catch (reason) {
      if (number !== this.newest) return; // others were chosen meanwhile
      this.notice.wait(null);
      this.notice.say(sentence(reason));
    }
  }

  /** Null: not to be shown; `late`: others were chosen meanwhile. */
  private async sceneOf(files: readonly File[], late: () => boolean): Promise<OwnScene | null> {
    const bytes = files.reduce((sum, { size }) => sum + size, 0);
    checkLimit(files.length === 1 ? files[0]!.name : `These ${files.length} files`, bytes, MOST_BYTES);
    const [scene, another] = files.filter(isScene);
    if (another) throw new Error(`Open one scene at a time: ${scene!.name} and ${another.name} are two.`);
    if (scene) return this.readScene(scene, files.filter((file) => file !== scene), late);
    if (files.length > 1)
      throw new Error(
        `Open one mesh at a time, or a scene with the meshes that it names: these are ${files.length} meshes.`,
      );
    return this.readMesh(files[0]!, late);
  }

  private async readMesh(file: File, late: () => boolean): Promise<OwnScene | null> {
    this.notice.wait(`Reading ${file.name} …`);
    const { mesh } = await readApart(file.name, { kind: "mesh", file });
    if (late()) return null;
    this.notice.wait(null);
    if (mesh.vertices > MOST_CLOTH_NODES) checkLimit(file.name, mesh.triangles, MOST_OBSTACLE_TRIANGLES, "triangles");
    const use = await this.dialog.ask(file.name, mesh);
    return use && sceneOfMesh(file.name, mesh, use.role, use.length);
  }

  private async readScene(file: File, others: readonly File[], late: () => boolean): Promise<OwnScene | null> {
    checkLimit(file.name, file.size, MOST_SCENE_BYTES);
    this.notice.wait(`Reading ${file.name} …`);
    const text = await file.text();
    const files: Record<string, File> = {};
    const models: Record<string, ArrayBuffer> = {};
    for (const name of namesIn(text)) {
      const brought = others.find((other) => [name, `${name}.ply`].map(bare).includes(bare(other.name)));
      if (brought) files[name] = brought;
      else models[name] = await fetchModel(name).catch(() => {
          throw new Error(
            `${file.name} names the mesh ${name}, which is neither part of this page nor among the files: ` +
              "open it along with the scene.",
          );
        });
    }
    const { size, meshes } = await readApart(file.name, { kind: "scene", scene: text, files, models });
    if (late()) return null;
    checkLimit(file.name, size.nodes, MOST_SCENE_NODES, "nodes");
    checkLimit(file.name, size.obstacleTriangles, MOST_OBSTACLE_TRIANGLES, "triangles of obstacles");
    this.notice.wait(null);
    return sceneOfJson(file.name, text, meshes);
  }

  private async showOwn(own: OwnScene): Promise<void> {
    const before = ownScene();
    offer(own);
    await this.show(plain(OWN, this.player.state.view));
    if (this.player.loaded?.json !== own.json) offer(before); // it could not be opened
  }
}

/** The list of scenes has it too, from now on. */
function offer(own: OwnScene | null): void {
  keepOwnScene(own);
  const list = select("scene");
  const option = [...list.options].find(({ value }) => value === OWN);
  if (!own) option?.remove();
  else if (option) option.textContent = own.title;
  else list.add(new Option(own.title, OWN));
}

/** None where the text is no JSON: the core says what is wrong with it. */
function namesIn(text: string): string[] {
  try {
    return meshNames(text);
  } catch {
    return [];
  }
}

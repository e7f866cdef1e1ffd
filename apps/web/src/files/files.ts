// The panel's section of files: opening, saving, recording.
import { button, element, input } from "../elements.js";
import type { Notice } from "../notice.js";
import type { Player } from "../player.js";
import type { LoadedScene } from "../scenes.js";
import { sentence } from "../sentence.js";
import type { PageState } from "../state/page_state.js";
import type { World } from "weft-cloth";
import { acceptDrops } from "./drop.js";
import { download, fileName, savePicture, saveShape, SHAPES } from "./export.js";
import { MOST_VIDEO_SECONDS } from "./limits.js";
import { FileOpener } from "./open_files.js";
import { Recorder, recordingFault } from "./record.js";
import { isState, openState, saveState } from "./saved_state.js";

const clock = (seconds: number): string =>
  `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;

export class Files {
  private recorder: Recorder | null = null;

  constructor(private readonly player: Player, private readonly notice: Notice,
    private readonly canvas: HTMLCanvasElement, show: (state: PageState) => Promise<unknown>) {
    const opener = new FileOpener(player, notice, show);
    const open = (files: readonly File[]): Promise<void> => {
      const [first, ...more] = files;
      return first && more.length === 0 && isState(first) ? this.openState(first) : opener.open(files);
    };
    const chooser = input("file-chooser");
    button("open-file").addEventListener("click", () => chooser.click());
    chooser.addEventListener("change", () => {
      const files = [...chooser.files!];
      chooser.value = ""; // the same file again is a change too
      void open(files);
    });
    acceptDrops((files) => {
      if (!document.body.classList.contains("without-gpu")) void open(files);
    });
    const states = input("state-chooser");
    button("open-state").addEventListener("click", () => states.click());
    states.addEventListener("change", () => {
      const [file] = states.files!;
      states.value = "";
      if (file) void this.openState(file);
    });
    button("save-state").addEventListener("click", () => void this.save(saveState));
    for (const shape of SHAPES)
      button(`save-${shape}`).addEventListener("click",
        () => void this.save((world, scene) => saveShape(world, scene, shape)));
    button("save-png").addEventListener("click",
      () => void this.save((world, scene) => savePicture(world, scene, canvas)));
    button("record").addEventListener("click", () => void this.record());
  }

  /** `make` saves a file and gives its name. */
  private async save(make: (world: World, scene: LoadedScene) => Promise<string>): Promise<void> {
    const scene = this.player.loaded;
    if (!scene) return this.notice.say("There is nothing to save: no scene is shown.");
    const name = await this.player.ask((world) => make(world, scene));
    if (name !== null) this.notice.announce(`Saved ${name}.`);
  }

  private async openState(file: File): Promise<void> {
    try {
      const opened = await openState(file, this.player);
      if (!opened) return;
      this.notice.clearError(); // it was about the cloth before
      this.notice.announce(`Opened ${file.name}.`);
      if (opened.otherOrigin !== null) this.notice.say(opened.otherOrigin, "warning");
    } catch (reason) {
      this.notice.say(sentence(reason));
    }
  }

  private async record(): Promise<void> {
    if (this.recorder) return this.recorder.stop();
    const fault = recordingFault(this.canvas);
    const { loaded, live } = this.player;
    if (fault !== null) return this.notice.say(fault);
    if (!loaded || !live) return this.notice.say("There is nothing to record: no scene is shown.");
    const frame = live.statistics.frames;
    try {
      this.recorder = new Recorder(this.canvas, (seconds) => this.showTime(seconds));
      this.showTime(0);
      live.redraw(); // a paused cloth is a picture too
      const { content, end } = await this.recorder.done;
      const name = fileName(loaded, frame, end);
      download(name, content);
      this.notice.announce(`Saved ${name}.`);
    } catch (reason) {
      this.notice.say(sentence(reason));
    }
    this.recorder = null;
    this.showTime(null);
  }

  /** Null: nothing is recorded. */
  private showTime(seconds: number | null): void {
    button("record").dataset["recording"] = String(seconds !== null);
    element("record-label", HTMLSpanElement).textContent = seconds === null ?
      "Record a video" :
      `Stop: ${clock(seconds)} of ${clock(MOST_VIDEO_SECONDS)}`;
  }
}

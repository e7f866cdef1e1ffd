// The canvas as a video, by the browser's own encoder.
import { MOST_VIDEO_SECONDS } from "./limits.js";

const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"]; // the first that the browser has
const BITS_PER_PIXEL = 6; // a second: fine folds stay, 8 Mbit/s at 1440 × 900
const PIECE = 1000; // [ms], so that the encoder need not keep it all

export interface Recording {
  content: Blob;
  end: "webm" | "mp4";
}

/** Why the canvas cannot be recorded here; null: it can. */
export function recordingFault(canvas: HTMLCanvasElement): string | null {
  if (typeof MediaRecorder === "undefined" || !("captureStream" in canvas))
    return "This browser cannot record a canvas: it has no MediaRecorder for it.";
  if (!TYPES.some((type) => MediaRecorder.isTypeSupported(type)))
    return "This browser records neither WebM nor MP4.";
  return null;
}

export class Recorder {
  private readonly recorder: MediaRecorder;
  private readonly pieces: Blob[] = [];
  private readonly clock: ReturnType<typeof setInterval>;
  private readonly start = performance.now();
  /** Once it has been stopped, by `stop` or because the longest time is over. */
  readonly done: Promise<Recording>;

  constructor(canvas: HTMLCanvasElement, elapsed: (seconds: number) => void) {
    const type = TYPES.find((each) => MediaRecorder.isTypeSupported(each))!;
    const stream = canvas.captureStream();
    this.recorder = new MediaRecorder(stream, {
      mimeType: type, videoBitsPerSecond: Math.round(BITS_PER_PIXEL * canvas.width * canvas.height) });
    this.recorder.addEventListener("dataavailable", ({ data }) => this.pieces.push(data));
    this.done = new Promise<Recording>((resolve, reject) => {
      this.recorder.addEventListener("error", () => reject(new Error("The browser's encoder has failed; there is no video.")));
      this.recorder.addEventListener("stop", () => {
        const content = new Blob(this.pieces, { type: type.replace(/;.*/, "") });
        if (content.size === 0) reject(new Error("The video is empty: nothing was drawn while it was recorded."));
        else resolve({ content, end: type.startsWith("video/mp4") ? "mp4" : "webm" });
      });
    }).finally(() => {
      clearInterval(this.clock);
      for (const track of stream.getTracks()) track.stop();
    });
    this.clock = setInterval(() => {
      const seconds = (performance.now() - this.start) / 1000;
      elapsed(seconds);
      if (seconds >= MOST_VIDEO_SECONDS) this.stop();
    }, 250);
    this.recorder.start(PIECE);
  }

  stop(): void {
    if (this.recorder.state !== "inactive") this.recorder.stop();
  }
}

// The canvas as a video, by the browser's own encoder.
import { MOST_VIDEO_SECONDS } from "./limits.js";

// The first that the browser supports is used.
const TYPES = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
const BITS_PER_PIXEL = 6; // a second: fine folds stay, 8 Mbit/s at 1440 × 900
const PIECE = 1000; // [ms], so that the encoder need not keep it all
const FIRST_PIECE = 3; // [s]; an encoder needs its time to start, and what is stopped before that is empty

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
  private stopping = false;
  /** Once it has been stopped, by `stop` or because the longest time is over. */
  readonly done: Promise<Recording>;

  constructor(canvas: HTMLCanvasElement, elapsed: (seconds: number) => void) {
    const type = TYPES.find((each) => MediaRecorder.isTypeSupported(each))!;
    const stream = canvas.captureStream();
    this.recorder = new MediaRecorder(stream, {
      mimeType: type,
      videoBitsPerSecond: Math.round(BITS_PER_PIXEL * canvas.width * canvas.height),
    });
    this.recorder.addEventListener("dataavailable", ({ data }) => {
      if (data.size > 0) this.pieces.push(data);
      this.stopIfDue();
    });
    this.done = new Promise<Recording>((resolve, reject) => {
      this.recorder.addEventListener("error",
        () => reject(new Error("The browser's encoder has failed; there is no video.")));
      this.recorder.addEventListener("stop", () => {
        const content = new Blob(this.pieces, { type: type.replace(/;.*/, "") });
        if (content.size === 0) reject(new Error("The video is empty: the browser has encoded no picture."));
        else resolve({ content, end: type.startsWith("video/mp4") ? "mp4" : "webm" });
      });
    }).finally(() => {
      clearInterval(this.clock);
      for (const track of stream.getTracks()) track.stop();
    });
    this.clock = setInterval(() => {
      elapsed(Math.min(this.seconds, MOST_VIDEO_SECONDS));
      if (this.seconds >= MOST_VIDEO_SECONDS) this.stopping = true;
      this.stopIfDue();
    }, 250);
    this.recorder.start(PIECE);
  }

  /** Ends the recording, as soon as there is one. */
  stop(): void {
    this.stopping = true;
    this.stopIfDue();
  }

  private get seconds(): number {
    return (performance.now() - this.start) / 1000;
  }

  private stopIfDue(): void {
    const due = this.stopping && (this.pieces.length > 0 || this.seconds > FIRST_PIECE);
    if (due && this.recorder.state !== "inactive") this.recorder.stop();
  }
}

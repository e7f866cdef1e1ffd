// The hardware that was measured on, as far as the browser tells.

export interface Hardware {
  readonly date: string;
  readonly browser: string;
  readonly processors: number;
  /** Null where there is no adapter. */
  readonly webgpu: { readonly vendor: string; readonly architecture: string; readonly device: string;
    readonly description: string } | null;
  /** The renderer's name; null where there is no WebGL 2. */
  readonly webgl2: string | null;
}

export async function hardware(): Promise<Hardware> {
  const adapter = await (navigator as { gpu?: GPU }).gpu?.requestAdapter({ powerPreference: "high-performance" }).catch(
    () => null,
  );
  const info = adapter?.info;
  return {
    date: new Date().toISOString(),
    browser: navigator.userAgent,
    processors: navigator.hardwareConcurrency,
    webgpu: info ?
      { vendor: info.vendor, architecture: info.architecture, device: info.device, description: info.description } :
      null,
    webgl2: webgl2Renderer(),
  };
}

export function adapterName({ webgpu }: Hardware): string | null {
  if (!webgpu) return null;
  return [webgpu.vendor, webgpu.architecture, webgpu.device, webgpu.description].filter(Boolean).join(" ") ||
    "unnamed adapter";
}

function webgl2Renderer(): string | null {
  const gl = document.createElement("canvas").getContext("webgl2", { powerPreference: "high-performance" });
  if (!gl) return null;
  const unmasked = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(unmasked ? unmasked.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return name;
}

// What is said of an adapter; older browsers give no info.
export function nameOf(info: GPUAdapterInfo | undefined): string {
  return info?.description || info?.device || `${info?.vendor ?? ""} ${info?.architecture ?? ""}`.trim() ||
    "unnamed adapter";
}

export function isNamed(info: GPUAdapterInfo | undefined, wanted: string): boolean {
  return nameOf(info).toLowerCase().includes(wanted.toLowerCase());
}
export function noneNamed(wanted: string, info: GPUAdapterInfo | undefined): string {
  return `No adapter's name contains "${wanted}"; there is: ${nameOf(info)}.`;
}

/** Its name, vendor, driver, back end and type, a line each. */
export function describe(info: GPUAdapterInfo | undefined): string {
  return [nameOf(info), info?.vendor ?? "", info?.description ?? "", "WebGPU",
    info?.isFallbackAdapter ? "CPU" : "unknown"].join("\n");
}

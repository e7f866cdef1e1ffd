// All hosts of these tests run on SwiftShader's Vulkan driver, as Chromium brings it: the same adapter under wgpu, Dawn
// in Node and Dawn in Chromium. Vulkan reads the variables when a process starts, so they are set before any worker.
export const SWIFTSHADER = "/usr/lib/chromium/vk_swiftshader_icd.json";

export default function setup(): void {
  Object.assign(process.env, { VK_DRIVER_FILES: SWIFTSHADER, VK_ICD_FILENAMES: SWIFTSHADER });
}

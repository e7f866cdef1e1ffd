// All hosts of these tests run on SwiftShader's Vulkan driver, as Chromium brings it: the same adapter under wgpu, Dawn
// in Node and Dawn in Chromium. Vulkan reads the variables when a process starts, so they are set before any worker.
export const SWIFTSHADER = "/usr/lib/chromium/vk_swiftshader_icd.json";

/** A feature of Dawn: SwiftShader compiles a store for each word of workgroup memory that it is asked to set to zero,
 * up to 4 s for a kernel. Dawn's own loop, in its place, does the same. */
export const SLOW_ON_SWIFTSHADER = "use_vulkan_zero_initialize_workgroup_memory_extension";

export default function setup(): void {
  Object.assign(process.env, { VK_DRIVER_FILES: SWIFTSHADER, VK_ICD_FILENAMES: SWIFTSHADER });
}

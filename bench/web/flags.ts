/** SwiftShader for WebGPU, its canvas and WebGL at once. */
export const SOFTWARE_FLAGS = "--enable-unsafe-webgpu --use-webgpu-adapter=swiftshader --enable-features=Vulkan --use-vulkan=swiftshader " +
  "--use-angle=swiftshader --enable-unsafe-swiftshader";

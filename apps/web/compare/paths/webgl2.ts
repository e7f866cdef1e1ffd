// Baseline that the paper leaves out: mass-spring on the GPU without WebGPU, by fragment shaders of WebGL 2. Positions
// and velocities lie in float textures, a step is one draw into the other pair, and the picture reads the textures:
// nothing comes back. GPU cloth of this kind is older than compute shaders in browsers (C. Zeller, "Cloth Simulation on
// the GPU", SIGGRAPH 2005 sketches). The physics is weft's: docs/solvers/mass_spring.md, node-centric.
import { Matrix4 } from "three";
import { restPositions, triangles, type Sheet } from "../sheet.js";
import { cameraOf } from "./camera.js";
import { HEIGHT, Unavailable, WIDTH, type Open, type Path } from "./path.js";
import { ADVANCE, CLOTH_FRAGMENT, CLOTH_VERTEX, COVER } from "./webgl2_shaders.js";

interface State {
  position: WebGLTexture;
  velocity: WebGLTexture;
  target: WebGLFramebuffer;
}

class WebGl2Path implements Path {
  readonly leastSteps = 1;
  private readonly advance: WebGLProgram;
  private readonly cloth: WebGLProgram;
  private readonly states: [now: State, next: State];
  private readonly indices: number;
  private readonly texel = new Float32Array(4);
  private readonly pixel = new Uint8Array(4);

  constructor(private readonly gl: WebGL2RenderingContext, private readonly sheet: Sheet) {
    const { nx, ny } = sheet;
    this.advance = program(gl, COVER, ADVANCE);
    this.cloth = program(gl, CLOTH_VERTEX, CLOTH_FRAGMENT);
    const rest = new Float32Array(4 * nx * ny);
    restPositions(sheet).forEach((value, at) => {
      rest[4 * Math.floor(at / 3) + (at % 3)] = value;
    });
    this.states = [state(gl, nx, ny, rest), state(gl, nx, ny, rest)];
    const index = triangles(nx, ny);
    this.indices = index.length;
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
    this.setConstants();
    const error = gl.getError();
    if (error !== gl.NO_ERROR) throw new Error(`WebGL 2 cannot hold a sheet of ${nx} × ${ny} nodes (error ${error}).`);
  }

  async simulate(count: number): Promise<void> {
    for (let i = 0; i < count; i++) this.step();
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.states[0].target);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, this.texel); // waits for all steps (measure.ts)
  }

  async animate(count: number): Promise<void> {
    const { gl } = this;
    for (let i = 0; i < count; i++) {
      this.step();
      this.draw();
    }
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, this.pixel); // waits for all pictures
  }

  async positions(): Promise<Float32Array> {
    const { gl, sheet: { nx, ny } } = this;
    const texels = new Float32Array(4 * nx * ny);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.states[0].target);
    gl.readPixels(0, 0, nx, ny, gl.RGBA, gl.FLOAT, texels);
    return texels.filter((_, at) => at % 4 !== 3);
  }

  dispose(): void {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private step(): void {
    const { gl, sheet: { nx, ny } } = this;
    const [now, next] = this.states;
    gl.bindFramebuffer(gl.FRAMEBUFFER, next.target);
    gl.viewport(0, 0, nx, ny);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(this.advance);
    bindTextures(gl, now);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    this.states.reverse();
  }

  private draw(): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, WIDTH, HEIGHT);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.cloth);
    bindTextures(gl, this.states[0]);
    gl.drawElements(gl.TRIANGLES, this.indices, gl.UNSIGNED_INT, 0);
  }

  private setConstants(): void {
    const { gl, sheet: { nx, ny, springs, damping, nodeMass, gravity, step } } = this;
    const [alongI, alongJ, diagonal, , bend] = springs as [Spring, Spring, Spring, Spring, Spring];
    const advance = (name: string) => gl.getUniformLocation(this.advance, name);
    gl.useProgram(this.advance);
    gl.uniform1i(advance("velocity"), 1);
    gl.uniform2i(advance("size"), nx, ny);
    gl.uniform3f(advance("stiffness"), alongI.stiffness, diagonal.stiffness, bend.stiffness);
    gl.uniform3f(advance("rest_length"), alongI.restLength, alongJ.restLength, diagonal.restLength);
    gl.uniform1f(advance("damping"), damping);
    gl.uniform1f(advance("inverse_mass"), 1 / nodeMass);
    gl.uniform3f(advance("gravity"), ...gravity);
    gl.uniform1f(advance("dt"), step);
    const eye = cameraOf(this.sheet);
    const viewProjection = new Matrix4().multiplyMatrices(eye.projectionMatrix, eye.matrixWorldInverse);
    gl.useProgram(this.cloth);
    gl.uniform2i(gl.getUniformLocation(this.cloth, "size"), nx, ny);
    gl.uniformMatrix4fv(gl.getUniformLocation(this.cloth, "view_projection"), false, viewProjection.elements);
    gl.clearColor(0x20 / 255, 0x26 / 255, 0x2c / 255, 1);
  }
}

type Spring = Sheet["springs"][number];

function bindTextures(gl: WebGL2RenderingContext, { position, velocity }: State): void {
  gl.activeTexture(gl.TEXTURE1);
  gl.bindTexture(gl.TEXTURE_2D, velocity);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, position);
}

function state(gl: WebGL2RenderingContext, nx: number, ny: number, rest: Float32Array): State {
  const texture = (texels: Float32Array | null) => {
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, nx, ny);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    if (texels) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, nx, ny, gl.RGBA, gl.FLOAT, texels);
    return made;
  };
  const position = texture(rest), velocity = texture(null); // a new texture is 0
  const target = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, position, 0);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT1, gl.TEXTURE_2D, velocity, 0);
  gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
  return { position, velocity, target };
}

function program(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const made = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind);
    if (!shader) throw new Error("The WebGL 2 context is lost.");
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS))
    throw new Error(`A shader of the WebGL 2 path does not compile: ${gl.getProgramInfoLog(made)}`);
  return made;
}

export const open: Open = async (sheet, canvas) => {
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "high-performance" });
  if (!gl) throw new Unavailable("This browser offers no WebGL 2.");
  if (!gl.getExtension("EXT_color_buffer_float"))
    throw new Unavailable("WebGL 2 here cannot draw into float textures (EXT_color_buffer_float).");
  return new WebGl2Path(gl, sheet);
};

// The CPU baseline drawn by three.js on WebGL: positions and normals are uploaded for every picture.
import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Mesh, type PerspectiveCamera, Scene,
  ShaderMaterial, WebGLRenderer } from "three";
import { CpuSheet } from "../cpu_sheet.js";
import { triangles, type Sheet } from "../sheet.js";
import { cameraOf } from "./camera.js";
import { HEIGHT, Unavailable, WIDTH, type Open, type Path } from "./path.js";

// weft's view "normals": byte = 255 (½ + ½ n) of the normal that faces the eye.
const VERTEX = `
varying vec3 n;
void main() { n = normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;
const FRAGMENT = `
varying vec3 n;
void main() { vec3 m = normalize(n); gl_FragColor = vec4(0.5 + 0.5 * (gl_FrontFacing ? m : -m), 1.0); }`;

/**
 * Normals of a grid, not of unit length: the span of the neighbours in a row times that of those in a column. A tenth
 * of the cost of three.js's computeVertexNormals, which visits every triangle.
 */
export function gridNormals(position: Float64Array, nx: number, ny: number, out: Float32Array): void {
  for (let j = 0, at = 0; j < ny; j++) {
    const up = j > 0 ? -3 * nx : 0, down = j + 1 < ny ? 3 * nx : 0;
    for (let i = 0; i < nx; i++, at += 3) {
      const l = at - (i > 0 ? 3 : 0), r = at + (i + 1 < nx ? 3 : 0), u = at + up, d = at + down;
      const ax = position[r]! - position[l]!, ay = position[r + 1]! - position[l + 1]!,
        az = position[r + 2]! - position[l + 2]!;
      const bx = position[u]! - position[d]!, by = position[u + 1]! - position[d + 1]!,
        bz = position[u + 2]! - position[d + 2]!;
      out[at] = ay * bz - az * by;
      out[at + 1] = az * bx - ax * bz;
      out[at + 2] = ax * by - ay * bx;
    }
  }
}

class CpuPath implements Path {
  readonly leastSteps = 1;
  private readonly cloth: CpuSheet;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera: PerspectiveCamera;
  private readonly geometry = new BufferGeometry();
  private readonly material = new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, side: DoubleSide });
  private readonly place: BufferAttribute;
  private readonly normal: BufferAttribute;
  private readonly pixel = new Uint8Array(4);

  constructor(private readonly sheet: Sheet, canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    const { nx, ny } = sheet;
    this.camera = cameraOf(sheet);
    this.cloth = new CpuSheet(sheet);
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.setSize(WIDTH, HEIGHT, false);
    this.renderer.setClearColor(0x20262c);
    this.place = new BufferAttribute(new Float32Array(3 * nx * ny), 3).setUsage(DynamicDrawUsage);
    this.normal = new BufferAttribute(new Float32Array(3 * nx * ny), 3).setUsage(DynamicDrawUsage);
    this.geometry.setAttribute("position", this.place);
    this.geometry.setAttribute("normal", this.normal);
    this.geometry.setIndex(new BufferAttribute(triangles(nx, ny), 1));
    const mesh = new Mesh(this.geometry, this.material);
    mesh.frustumCulled = false; // no bounds to compute in every frame
    this.scene.add(mesh);
  }

  async simulate(count: number): Promise<void> {
    for (let i = 0; i < count; i++) this.cloth.step();
  }

  async animate(count: number): Promise<void> {
    for (let i = 0; i < count; i++) {
      this.cloth.step();
      this.draw();
    }
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, this.pixel); // waits for all pictures (measure.ts)
  }

  async positions(): Promise<Float32Array> {
    return Float32Array.from(this.cloth.position);
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  private draw(): void {
    this.place.array.set(this.cloth.position);
    this.place.needsUpdate = true;
    gridNormals(this.cloth.position, this.sheet.nx, this.sheet.ny, this.normal.array as Float32Array);
    this.normal.needsUpdate = true;
    this.renderer.render(this.scene, this.camera);
  }
}

export const open: Open = async (sheet, canvas) => {
  const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "high-performance" });
  if (!context) throw new Unavailable("This browser offers no WebGL 2.");
  return new CpuPath(sheet, canvas, context);
};

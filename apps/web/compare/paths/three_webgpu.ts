// Baseline: three.js's own way to compute on WebGPU, as its example webgpu_compute_cloth is built (three.js r187, MIT):
// TSL kernels, one over springs that writes each spring's force, one over vertices that sums the forces of a vertex's
// list of springs and moves it, and a node material that draws from the same buffer. The constants, the damping along
// the spring and the integration are weft's (docs/solvers/mass_spring.md); the example's wind, sphere and environment
// are left out.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, LinearSRGBColorSpace, Mesh, MeshBasicNodeMaterial, Scene,
  type StorageBufferAttribute, Vector3, WebGPURenderer, type Node } from "three/webgpu";
import { cross, float, Fn, frontFacing, If, instanceIndex, instancedArray, Loop, Return, select, uint, uniform, varying,
  vec3, vec4, vertexIndex } from "three/tsl";
import { restPositions, springCount, triangles, type Sheet } from "../sheet.js";
import { springLists } from "../spring_lists.js";
import { cameraOf } from "./camera.js";
import { HEIGHT, Unavailable, WIDTH, type Open, type Path } from "./path.js";

const MIN_LENGTH = 1e-9; // m; a shorter spring has no direction, and pulls nowhere

/** The two kernels of a step, in their order, and the buffer of positions that they move. */
function kernels(sheet: Sheet) {
  const lists = springLists(sheet);
  const vertexCount = sheet.nx * sheet.ny;
  const position = instancedArray(Float32Array.from(restPositions(sheet)), "vec3");
  const velocity = instancedArray(vertexCount, "vec3");
  const vertexSpringCount = instancedArray(lists.count, "uint");
  const vertexSpringPointer = instancedArray(lists.begin, "uint");
  const springList = instancedArray(lists.ofNode, "uint");
  const springVertexIds = instancedArray(lists.nodes, "uvec2");
  const springRestLength = instancedArray(lists.restLength, "float");
  const springStiffness = instancedArray(lists.stiffness, "float");
  const springForce = instancedArray(springCount(sheet), "vec3");
  const damping = uniform(sheet.damping), inverseMass = uniform(1 / sheet.nodeMass), step = uniform(sheet.step);
  const gravity = uniform(new Vector3(...sheet.gravity));

  const springForces = Fn(() => {
    const ids = springVertexIds.element(instanceIndex).toVar();
    const delta = position.element(ids.y).sub(position.element(ids.x)).toVar();
    const length = delta.length().max(MIN_LENGTH).toVar();
    const direction = delta.div(length).toVar();
    const rate = velocity.element(ids.y).sub(velocity.element(ids.x)).dot(direction);
    const stretch = length.sub(springRestLength.element(instanceIndex));
    const tension = springStiffness.element(instanceIndex).mul(stretch).add(damping.mul(rate));
    springForce.element(instanceIndex).assign(direction.mul(tension));
  })().compute(springCount(sheet));

  const vertexForces = Fn(() => {
    const begin = vertexSpringPointer.element(instanceIndex).toVar();
    const count = vertexSpringCount.element(instanceIndex).toVar();
    If(count.equal(uint(0)), () => {
      Return();
    }); // pinned
    const force = vec3(0).toVar();
    Loop({ start: begin, end: begin.add(count), type: "uint", condition: "<" }, ({ i }) => {
      const spring = springList.element(i).toVar();
      const sign = select(springVertexIds.element(spring).x.equal(instanceIndex), float(1), float(-1));
      force.addAssign(springForce.element(spring).mul(sign));
    });
    const next = velocity.element(instanceIndex).add(gravity.add(force.mul(inverseMass)).mul(step)).toVar();
    velocity.element(instanceIndex).assign(next);
    position.element(instanceIndex).addAssign(next.mul(step));
  })().compute(vertexCount);

  return { position, springForces, vertexForces };
}

/** A mesh whose vertices are read from the buffer; the normal is that of the grid (paths/cpu.ts). */
function clothMesh({ nx, ny }: Sheet, position: ReturnType<typeof kernels>["position"]): Mesh {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * nx * ny), 3));
  geometry.setIndex(new BufferAttribute(triangles(nx, ny), 1));
  const normal = varying(vec3(0), "gridNormal");
  const material = new MeshBasicNodeMaterial({ side: DoubleSide });
  material.positionNode = Fn(() => {
    const i = vertexIndex.mod(uint(nx)).toVar(), j = vertexIndex.div(uint(nx)).toVar();
    const beside = (atEdge: Node<"bool">, node: Node<"uint">) => position.element(select(atEdge, vertexIndex, node));
    const along = beside(i.equal(uint(nx - 1)), vertexIndex.add(uint(1))).sub(
      beside(i.equal(uint(0)), vertexIndex.sub(uint(1))),
    );
    const up = beside(j.equal(uint(0)), vertexIndex.sub(uint(nx))).sub(
      beside(j.equal(uint(ny - 1)), vertexIndex.add(uint(nx))),
    );
    normal.assign(cross(along, up));
    return position.element(vertexIndex);
  })();
  const facing = normal.normalize().mul(select(frontFacing, float(1), float(-1)));
  material.fragmentNode = vec4(facing.mul(0.5).add(0.5), 1); // weft's view "normals"
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}

class ThreePath implements Path {
  readonly leastSteps = 1;
  private readonly scene = new Scene();
  private readonly camera;
  private readonly kernels;
  private readonly mesh: Mesh;

  constructor(private readonly renderer: WebGPURenderer, private readonly queue: GPUQueue, sheet: Sheet) {
    this.kernels = kernels(sheet);
    this.camera = cameraOf(sheet);
    this.mesh = clothMesh(sheet, this.kernels.position);
    this.scene.add(this.mesh);
  }

  async simulate(count: number): Promise<void> {
    for (let i = 0; i < count; i++) this.step();
    await this.queue.onSubmittedWorkDone();
  }

  async animate(count: number): Promise<void> {
    for (let i = 0; i < count; i++) {
      this.step();
      this.renderer.render(this.scene, this.camera);
    }
    await this.queue.onSubmittedWorkDone();
  }

  async positions(): Promise<Float32Array> {
    const bytes = await this.renderer.getArrayBufferAsync(this.kernels.position.value as StorageBufferAttribute);
    return new Float32Array(bytes as ArrayBuffer).filter((_, at) => at % 4 !== 3); // three.js pads to four
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    (this.mesh.material as MeshBasicNodeMaterial).dispose();
    this.renderer.dispose();
  }

  private step(): void {
    this.renderer.compute(this.kernels.springForces);
    this.renderer.compute(this.kernels.vertexForces);
  }
}

export const open: Open = async (sheet, canvas) => {
  if (!(await (navigator as { gpu?: GPU }).gpu?.requestAdapter().catch(() => null)))
    throw new Unavailable("This browser offers no WebGPU adapter.");
  const renderer = new WebGPURenderer({ canvas, antialias: true, powerPreference: "high-performance" });
  renderer.outputColorSpace = LinearSRGBColorSpace; // bytes as the material says
  renderer.setSize(WIDTH, HEIGHT, false);
  renderer.setClearColor(new Color().setRGB(0x20 / 255, 0x26 / 255, 0x2c / 255));
  await renderer.init();
  const { device } = renderer.backend as unknown as { device?: GPUDevice };
  if (!device) throw new Unavailable("three.js has chosen WebGL instead of WebGPU here.");
  return new ThreePath(renderer, device.queue, sheet);
};

// A cloth of weft's in a scene of three.js: one device, and three.js draws weft's buffers where they lie. The ball is
// moved here; it is an object of three.js and a collider of weft's.
import * as THREE from "three/webgpu";
import { createWorld } from "weft-cloth";

const RADIUS = 0.3; // m

async function main() {
  const adapter = await navigator.gpu?.requestAdapter();
  if (!adapter) throw new Error("This browser has no WebGPU, or no adapter for this machine.");
  const device = await adapter.requestDevice(); // DEVICE_LIMITS of weft are WebGPU's defaults

  const world = await createWorld({
    scene: {
      format: "weft-scene/1",
      contact: { self: false },
      cloths: [{
        grid: [33, 33],
        size: [1.2, 1.2],
        plane: "xz",
        density: 0.2,
        stiffness: { structural: 300, shear: 80, bend: 2 },
        damping: 0.02,
        pins: ["corners"],
        transform: { translate: [0, RADIUS + 0.01, 0] },
      }],
      // Where the scene has it at the origin, its placement is that of the object.
      colliders: [{ kind: "sphere", center: [0, 0, 0], radius: RADIUS, motion: { kind: "given", speed: 1 } }],
    },
    canvas: null,
    device,
  });

  const canvas = document.querySelector("canvas");
  const renderer = new THREE.WebGPURenderer({ canvas, device, antialias: true });
  renderer.shadowMap.enabled = true;
  await renderer.init();
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0xe8ecf0);
  const camera = new THREE.PerspectiveCamera(40, 1, 0.1, 20);
  camera.position.set(1.3, 0.8, 1.8);
  camera.lookAt(0, 0.1, 0);
  const sun = new THREE.DirectionalLight(0xffffff, 2.5);
  sun.position.set(1, 3, 1.5);
  sun.castShadow = true;
  sun.shadow.bias = -0.002;
  scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x8090a0, 1.2));

  const cloth = clothMesh(renderer, world.buffers());
  const ball = new THREE.Mesh(new THREE.SphereGeometry(RADIUS, 48, 24),
    new THREE.MeshStandardMaterial({ color: 0x3b6ea5, roughness: 0.5 }));
  ball.castShadow = true;
  ball.receiveShadow = true;
  scene.add(cloth.mesh, ball);

  new ResizeObserver(([{ contentRect: { width, height } }]) => {
    renderer.setSize(width, height, false);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }).observe(canvas);

  for (let frame = 1;; frame++) {
    const t = frame * world.info.frameSeconds;
    ball.position.set(0.25 * Math.sin(t), 0.15 * Math.sin(2 * t), 0.25 * Math.sin(1.5 * t));
    ball.rotation.y = t;
    await world.setCollider(0, { position: ball.position.toArray(), quaternion: ball.quaternion.toArray() });
    await world.step(1);
    cloth.use(world.buffers());
    renderer.render(scene, camera);
    document.documentElement.dataset.frame = String(frame);
    await new Promise(requestAnimationFrame);
  }
}

/**
 * A mesh that is drawn from weft's buffers. three.js makes a buffer of its own for an attribute unless its back end has
 * one already: that is where weft's are put, anew in each frame, since positions have two that take turns. The arrays
 * only say how long the buffers are. Such a geometry is not disposed of: three.js would destroy weft's buffers.
 */
function clothMesh(renderer, { position, normal, triangles }) {
  const bySixteen = ({ count, stride }) =>
    new THREE.InterleavedBuffer(new Float32Array(count * stride / 4), stride / 4);
  const positions = bySixteen(position), normals = bySixteen(normal);
  const corners = new THREE.BufferAttribute(new Uint32Array(3 * triangles.count), 1);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.InterleavedBufferAttribute(positions, 3, 0));
  geometry.setAttribute("normal", new THREE.InterleavedBufferAttribute(normals, 3, 0));
  geometry.setIndex(corners);
  const mesh = new THREE.Mesh(geometry,
    new THREE.MeshStandardMaterial({ color: 0xc8553d, roughness: 0.85, side: THREE.DoubleSide }));
  mesh.frustumCulled = false; // three.js knows no place of it
  mesh.castShadow = true;
  mesh.receiveShadow = true;
  const use = (buffers) => {
    renderer.backend.get(positions).buffer = buffers.position.buffer;
    renderer.backend.get(normals).buffer = buffers.normal.buffer;
    renderer.backend.get(corners).buffer = buffers.triangles.buffer;
  };
  use({ position, normal, triangles });
  return { mesh, use };
}

main().catch((error) => document.body.append(error.message));

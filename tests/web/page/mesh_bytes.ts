// Small meshes in every format that a visitor may bring, written here and not by the core.
import { gzipSync } from "node:zlib";

export interface Mesh {
  positions: readonly (readonly [number, number, number])[];
  triangles: readonly (readonly [number, number, number])[];
}

/** A dome of n × n vertices over the square from -1 to 1. */
export function dome(n: number): Mesh {
  const along = (i: number) => (2 * i) / (n - 1) - 1;
  const positions = Array.from({ length: n * n }, (_, k) => {
    const [x, z] = [along(k % n), along(Math.floor(k / n))];
    return [x, Math.fround(0.5 * Math.cos(x) * Math.cos(z)), z] as const;
  });
  const cells = Array.from({ length: (n - 1) * (n - 1) }, (_, k) => (k % (n - 1)) + n * Math.floor(k / (n - 1)));
  return { positions, triangles: cells.flatMap((a) => [[a, a + n, a + 1], [a + 1, a + n, a + n + 1]] as const) };
}

const rows = (values: readonly (readonly number[])[], before = "") =>
  values.map((row) => `${before}${row.join(" ")}\n`).join("");

export function obj({ positions, triangles }: Mesh): Buffer {
  return Buffer.from(rows(positions, "v ") + rows(triangles.map((t) => t.map((v) => v + 1)), "f "));
}

export function off({ positions, triangles }: Mesh): Buffer {
  return Buffer.from(`OFF\n${positions.length} ${triangles.length} 0\n${rows(positions)}${rows(triangles, "3 ")}`);
}

export function ply({ positions, triangles }: Mesh): Buffer {
  return Buffer.from(`ply\nformat ascii 1.0\nelement vertex ${positions.length}\n` +
    "property float x\nproperty float y\nproperty float z\n" +
    `element face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header\n` +
    rows(positions) + rows(triangles, "3 "));
}

export function stl({ positions, triangles }: Mesh): Buffer {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((corners, t) =>
    corners.forEach((vertex, c) =>
      positions[vertex]!.forEach((value, axis) => bytes.writeFloatLE(value, 84 + 50 * t + 12 * (c + 1) + 4 * axis))
    )
  );
  return bytes;
}

/** `change` is made in the JSON. */
export function glb({ positions, triangles }: Mesh, change = (json: string) => json): Buffer {
  const points = Buffer.from(new Float32Array(positions.flat()).buffer);
  const corners = Buffer.from(new Uint32Array(triangles.flat()).buffer);
  const json = change(JSON.stringify({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: positions.length, type: "VEC3" }, { bufferView: 1,
      componentType: 5125, count: 3 * triangles.length, type: "SCALAR" }],
    bufferViews: [{ buffer: 0, byteLength: points.length }, { buffer: 0, byteOffset: points.length,
      byteLength: corners.length }],
    buffers: [{ byteLength: points.length + corners.length }],
  }));
  const text = Buffer.from(json.padEnd(4 * Math.ceil(json.length / 4)));
  const word = (...values: number[]) => Buffer.from(new Uint32Array(values).buffer);
  const size = 12 + 8 + text.length + 8 + points.length + corners.length;
  return Buffer.concat([word(0x46546c67, 2, size, text.length, 0x4e4f534a), text,
    word(points.length + corners.length, 0x004e4942), points, corners]);
}

export const packed = (bytes: Buffer): Buffer => gzipSync(bytes);

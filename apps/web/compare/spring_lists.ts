// The sheet's springs as lists, for a path that knows no grid: each spring's two nodes, and each node's springs.
import { springCount, type Sheet } from "./sheet.js";

export interface SpringLists {
  /** Two nodes a spring. */
  nodes: Uint32Array<ArrayBuffer>;
  /** Of each spring [m], [N/m]. */
  restLength: Float32Array<ArrayBuffer>;
  stiffness: Float32Array<ArrayBuffer>;
  /** How many springs each node has, and where they begin in `ofNode`. A pinned node has none. */
  count: Uint32Array<ArrayBuffer>;
  begin: Uint32Array<ArrayBuffer>;
  ofNode: Uint32Array<ArrayBuffer>;
}

export function springLists(sheet: Sheet): SpringLists {
  const { nx, ny, springs, pinned } = sheet;
  const total = springCount(sheet);
  const nodes = new Uint32Array(2 * total), restLength = new Float32Array(total), stiffness = new Float32Array(total);
  let at = 0;
  for (let j = 0; j < ny; j++)
    for (let i = 0; i < nx; i++)
      for (const kind of springs) {
        if (i + kind.di < 0 || i + kind.di >= nx || j + kind.dj >= ny) continue;
        nodes[2 * at] = j * nx + i;
        nodes[2 * at + 1] = (j + kind.dj) * nx + i + kind.di;
        restLength[at] = kind.restLength;
        stiffness[at++] = kind.stiffness;
      }

  const count = new Uint32Array(nx * ny), begin = new Uint32Array(nx * ny);
  for (const node of nodes) count[node]! += 1;
  for (const node of pinned) count[node] = 0;
  for (let node = 1; node < begin.length; node++) begin[node] = begin[node - 1]! + count[node - 1]!;
  const ofNode = new Uint32Array(begin.at(-1)! + count.at(-1)!);
  const next = begin.slice();
  nodes.forEach((node, end) => {
    if (count[node] !== 0) ofNode[next[node]!++] = end >>> 1;
  });
  return { nodes, restLength, stiffness, count, begin, ofNode };
}

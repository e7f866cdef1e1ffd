import { OBJECT_KINDS, type GpuObject } from "./gpu_tables.js";

/** GPU objects under small numbers; 0 is none. */
export class GpuObjects {
  /** How many there are, for tests of leaks. */
  alive = 0;
  private objects: (GpuObject | null)[] = [null];
  private free: number[] = [];

  keep(object: GpuObject): number {
    this.alive += 1;
    const id = this.free.pop() ?? this.objects.length;
    this.objects[id] = object;
    return id;
  }

  get<T extends GpuObject>(id: number): T {
    return this.objects[id] as T;
  }

  release(kind: number, id: number): void {
    const object = this.objects[id];
    if (!object) return;
    const name = OBJECT_KINDS[kind];
    if (name === "buffer" || name === "texture" || name === "query-set") (object as GPUBuffer).destroy();
    this.objects[id] = null;
    this.free.push(id);
    this.alive -= 1;
  }

  clear(): void {
    for (const object of this.objects) if (object && "destroy" in object) object.destroy();
    this.objects = [null];
    this.free = [];
    this.alive = 0;
  }
}

// Geometry that was seen before: a source that sends a room again after each change leaves it out where it is the same.

export class Shapes {
  private shape = "";
  private glb = "";

  /** What the source need not send again; empty: nothing is known. */
  get known(): string {
    return this.shape;
  }

  /** A room with its geometry, as it came or as it is known. */
  whole(data: unknown): unknown {
    if (typeof data !== "object" || data === null || !("shape" in data) || typeof data.shape !== "string") return data;
    const glb = "glb" in data ? data.glb : null;
    if (typeof glb === "string") [this.shape, this.glb] = [data.shape, glb];
    return glb === null && data.shape === this.shape ? { ...data, glb: this.glb } : data;
  }
}

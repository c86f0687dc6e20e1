// The module behind its three functions: a request goes in as JSON, an answer comes out. For workers and for Node.

interface Exports {
  readonly memory: WebAssembly.Memory;
  scenelang_memory(length: number): number;
  scenelang_call(request: number, length: number): number;
}

export type Ask = (request: unknown) => unknown;

/** Starts an instance. What it is asked throws an error where it has no answer. */
export async function start(module: WebAssembly.Module): Promise<Ask> {
  const instance = await WebAssembly.instantiate(module, {});
  const exports = instance.exports as unknown as Exports;
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  return (request) => {
    const bytes = encoder.encode(JSON.stringify(request));
    const at = exports.scenelang_memory(bytes.length) >>> 0;
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    const answer = exports.scenelang_call(at, bytes.length) >>> 0;
    // The memory may have grown, and then is another buffer.
    const length = new DataView(exports.memory.buffer).getUint32(answer, true);
    const text = decoder.decode(new Uint8Array(exports.memory.buffer, answer + 4, length));
    const { ok, error } = JSON.parse(text) as { ok?: unknown; error?: string };
    if (error !== undefined) throw new Error(error);
    return ok;
  };
}

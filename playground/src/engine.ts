// The module behind its three functions: a request goes in as JSON, an answer comes out. For workers and for Node.

interface Exports {
  readonly memory: WebAssembly.Memory;
  scenelang_memory(length: number): number;
  scenelang_call(request: number, length: number): number;
}

/** Asks the module. The answer is its JSON: a text goes to another thread faster than what it says. */
export type Ask = (request: unknown) => string;

/** What an answer says; throws an error where there is none. */
export function read(answer: string): unknown {
  const { ok, error } = JSON.parse(answer) as { ok?: unknown; error?: string };
  if (error !== undefined) throw new Error(error);
  return ok;
}

/** Starts an instance. */
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
    return decoder.decode(new Uint8Array(exports.memory.buffer, answer + 4, length));
  };
}

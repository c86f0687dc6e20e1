// A program in the fragment of an address, which no browser sends to a server: `#p=` and JSON, deflated, in base64url. What comes from a
// link is text from a stranger: it is read as text, up to a size, and refused if it is anything else.

export interface Shared {
  readonly name: string;
  readonly text: string;
}

const MARK = "#p=";
/** Of the address, and of the program in it. */
const LONGEST = 200_000;
const LARGEST = 256 * 1024;

export async function encode(shared: Shared): Promise<string> {
  const bytes = new TextEncoder().encode(JSON.stringify([shared.name, shared.text]));
  const packed = await through(bytes, new CompressionStream("deflate-raw"), Infinity);
  let text = "";
  for (let at = 0; at < packed.length; at += 0x8000) text += String.fromCharCode(...packed.subarray(at, at + 0x8000));
  const fragment = MARK + btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
  if (fragment.length > LONGEST || shared.text.length > LARGEST / 4) throw new Error("the program is too long for a link; download it instead");
  return fragment;
}

/** The program of a fragment; `null`: it has none. An error says what is wrong with it. */
export async function decode(fragment: string): Promise<Shared | null> {
  if (fragment === "" || fragment === "#") return null;
  if (!fragment.startsWith(MARK)) throw new Error("it is not a link that the playground made");
  if (fragment.length > LONGEST) throw new Error("it is too long");
  const text = fragment.slice(MARK.length);
  if (!/^[A-Za-z0-9_-]+$/.test(text)) throw new Error("it has characters that no link of the playground has");
  let json: unknown;
  try {
    const packed = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const bytes = await through(packed, new DecompressionStream("deflate-raw"), LARGEST);
    json = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
  } catch (why) {
    throw new Error(why instanceof TooLarge ? "its program is too large" : "it is damaged");
  }
  if (!Array.isArray(json) || json.length !== 2 || typeof json[0] !== "string" || typeof json[1] !== "string") throw new Error("it holds no program");
  return { name: nameOf(json[0]), text: json[1] };
}

class TooLarge extends Error {}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > most) {
      void reader.cancel().catch(() => {});
      throw new TooLarge();
    }
    parts.push(value);
  }
  const out = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}

/** A name that files may have, ending in `.scene`. */
export function nameOf(name: string): string {
  const stem = name.replace(/\.scene$/, "").replace(/[^\p{L}\p{N} _-]+/gu, "-").slice(0, 60).trim();
  return `${/[\p{L}\p{N}]/u.test(stem) ? stem : "room"}.scene`;
}

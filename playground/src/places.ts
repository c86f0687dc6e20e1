// Where the program speaks of what is pressed in the room: rows of the report are called `file:line:column`, objects are declared.

import type { Pointed } from "../../viewer/src/source/source.js";

export function pointedAt(text: string, name: string, pointed: Pointed): readonly [number, number] | null {
  if ("object" in pointed) {
    const array = pointed.object.replace(/\[.*$/, "");
    const found = new RegExp(`^[ \\t]*object[ \\t]+(?:[^;\\n]*,[ \\t]*)?${escaped(array)}\\b`, "mu").exec(text);
    if (found === null) return null;
    const end = found.index + found[0].length;
    return [end - array.length, end];
  }
  const place = /:(\d+)(?::(\d+))?$/.exec(pointed.row);
  if (place === null || !pointed.row.includes(name)) return null;
  const lines = text.split("\n");
  const line = Number(place[1]) - 1;
  const own = lines[line];
  if (own === undefined) return null;
  const start = lines.slice(0, line).reduce((sum, before) => sum + before.length + 1, 0);
  const from = start + Math.min(own.length, Math.max(0, Number(place[2] ?? 1) - 1));
  return [from, start + own.length];
}

function escaped(text: string): string {
  return text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
}

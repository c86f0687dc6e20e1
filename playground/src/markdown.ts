// The Markdown that hovers are written in, as elements: paragraphs, lists, code. Whatever else is in it stays text; nothing
// becomes markup or a link.

import { el } from "../../viewer/src/dom.js";

export function markdown(text: string): HTMLElement {
  const out = el("div.markdown");
  let list: HTMLUListElement | null = null;
  let paragraph: string[] = [];
  const flush = () => {
    if (paragraph.length > 0) out.append(el("p", {}, ...inline(paragraph.join(" "))));
    paragraph = [];
  };
  const lines = text.split("\n");
  for (let at = 0; at < lines.length; at += 1) {
    const line = lines[at] ?? "";
    const item = /^\s*[-*] (.*)$/.exec(line);
    if (item === null) list = null;
    if (/^\s*```/.test(line)) {
      flush();
      const code: string[] = [];
      for (at += 1; at < lines.length && !/^\s*```/.test(lines[at] ?? ""); at += 1) code.push(lines[at] ?? "");
      out.append(el("pre", {}, code.join("\n")));
    } else if (item !== null) {
      flush();
      if (list === null) {
        list = el("ul");
        out.append(list);
      }
      list.append(el("li", {}, ...inline(item[1] ?? "")));
    } else if (/^\s*(---+)?$/.test(line)) flush();
    else paragraph.push(line.replace(/^#+ /, ""));
  }
  flush();
  return out;
}

function inline(text: string): (Node | string)[] {
  return text.split(/(`[^`]+`|\*\*[^*]+\*\*|\[[^\]]+\]\([^)]+\))/).map((part) => {
    if (part.length > 2 && part.startsWith("`") && part.endsWith("`")) return el("code", {}, part.slice(1, -1));
    if (part.length > 4 && part.startsWith("**") && part.endsWith("**")) return el("strong", {}, part.slice(2, -2));
    // An address is not followed from here, so its text is enough.
    const link = /^\[([^\]]+)\]\([^)]+\)$/.exec(part);
    return link?.[1] ?? part;
  });
}

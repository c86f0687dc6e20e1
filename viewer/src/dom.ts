// Building elements. Text goes in as text, never as markup, and no style attribute is written: a page with a strict
// content security policy may carry this.

export type Attributes = Readonly<Record<string, string | boolean | undefined>>;

/** `el("button.chip", {type: "button"}, "All")`: a tag with classes, its attributes (`false` leaves one out), its content. */
export function el<K extends keyof HTMLElementTagNameMap>(tag: K | `${K}.${string}`, attributes: Attributes = {}, ...content: (Node | string)[]): HTMLElementTagNameMap[K] {
  const [name, ...classes] = tag.split(".") as [K, ...string[]];
  const element = document.createElement(name);
  if (classes.length > 0) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes)) if (value !== undefined && value !== false) element.setAttribute(key, value === true ? "" : value);
  element.append(...content);
  return element;
}

/** Whether a key is typed into something, and is no command. */
export function typing(e: KeyboardEvent): boolean {
  const { target } = e;
  return target instanceof HTMLElement && (target.isContentEditable || target.matches("input, textarea, select"));
}

/** A 16 × 16 icon drawn by strokes. */
export function icon(path: string): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS(space, "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

export const ICONS = {
  holds: "M3.5 8.5l3 3 6-7",
  fails: "M4.5 4.5l7 7m0-7l-7 7",
  unknown: "M4 8h8",
  cube: "M8 1.8l5.5 3v6.4l-5.5 3-5.5-3V4.800zM2.500 4.800l5.500 3 5.500-3M8 7.800v6.400",
  plan: "M2.500 2.500h11v11h-11zM2.500 7.500h5M10 7.500h3.500M7.500 2.500v3M7.500 13.500v-3.500",
  reset: "M2.800 8a5.200 5.200 0 1 0 1.700-3.850M4.600 1.600v2.900h2.900",
  search: "M7 2.500a4.500 4.500 0 1 1 0 9a4.500 4.500 0 1 1 0-9zM10.300 10.300l3.500 3.500",
  close: "M4 4l8 8m0-8l-8 8",
} as const;

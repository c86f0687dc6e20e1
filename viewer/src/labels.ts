// Words over the picture: the tip at the pointer, name tags on what is selected, names of regions on a plan, and
// marks on objects whose constraints fail. They are elements moved with the camera, so they stay crisp and selectable.

import { type Camera, Vector3 } from "three";
import { el } from "./dom.js";

export type TagKind = "name" | "region" | "alert" | "gap";

export interface Tag {
  readonly kind: TagKind;
  readonly text: string;
  /** Where it hangs, in the scene. */
  readonly anchor: Vector3;
  /** For an alert: what pressing it selects. */
  readonly object?: string;
  readonly title?: string;
}

export class Labels {
  private readonly layer = el("div.labels");
  private readonly tip = el("div.tip", { role: "tooltip" });
  private placed: { tag: Tag; element: HTMLElement }[] = [];

  constructor(
    private readonly host: HTMLElement,
    private readonly chosen: (object: string) => void,
  ) {
    this.tip.hidden = true;
    host.append(this.layer, this.tip);
  }

  setTags(tags: readonly Tag[]): void {
    this.layer.replaceChildren();
    this.placed = tags.map((tag) => {
      const { object } = tag;
      const element = object === undefined ? el("div", {}, tag.text) : el("button", { type: "button", tabindex: "-1", title: tag.title }, tag.text);
      element.className = `tag ${tag.kind}`;
      if (object !== undefined) element.addEventListener("click", () => this.chosen(object));
      this.layer.append(element);
      return { tag, element };
    });
  }

  /** Puts every tag where its anchor is seen in a picture of a size. */
  place(camera: Camera, [width, height]: readonly [number, number]): void {
    const point = new Vector3();
    for (const { tag, element } of this.placed) {
      point.copy(tag.anchor).project(camera);
      element.hidden = Math.abs(point.x) > 1.05 || Math.abs(point.y) > 1.05 || point.z > 1 || point.z < -1;
      const x = Math.round(((point.x + 1) / 2) * width);
      const y = Math.round(((1 - point.y) / 2) * height);
      element.style.transform = `translate(${x}px, ${y}px) translate(-50%, ${tag.kind === "region" || tag.kind === "gap" ? "-50%" : "-100%"})`;
    }
  }

  /** Shows what is under the pointer, at a place of the window; nothing hides it. */
  showTip(tip: { title: string; lines: readonly string[] } | null, clientX: number, clientY: number): void {
    this.tip.hidden = tip === null;
    if (tip === null) return;
    this.tip.replaceChildren(el("strong", {}, tip.title), ...tip.lines.map((line) => el("span", {}, line)));
    const area = this.host.getBoundingClientRect();
    const { offsetWidth, offsetHeight } = this.tip;
    const x = Math.min(clientX - area.left + 16, area.width - offsetWidth - 8);
    const y = Math.min(clientY - area.top + 18, area.height - offsetHeight - 8);
    this.tip.style.transform = `translate(${Math.max(8, x)}px, ${Math.max(8, y)}px)`;
  }
}

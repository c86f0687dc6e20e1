// The few buttons over the picture: how to look at the room.

import type { Mode } from "./camera.js";
import { el, icon, ICONS } from "./dom.js";

export interface ToolbarEvents {
  show(mode: Mode): void;
  reset(): void;
}

export class Toolbar {
  readonly element = el("div.toolbar", { role: "toolbar", "aria-label": "View" });
  private readonly modes: Record<Mode, HTMLButtonElement>;

  constructor(events: ToolbarEvents) {
    const button = (text: string, path: string, title: string, pressed: () => void) => {
      const made = el("button", { type: "button", title }, icon(path), el("span", {}, text));
      made.addEventListener("click", pressed);
      return made;
    };
    this.modes = {
      perspective: button("3D", ICONS.cube, "Perspective view (P)", () => events.show("perspective")),
      plan: button("Plan", ICONS.plan, "Plan view, straight down (P)", () => events.show("plan")),
    };
    const reset = button("Reset", ICONS.reset, "Show the whole room (R)", () => events.reset());
    this.element.append(el("div.group", {}, this.modes.perspective, this.modes.plan), el("div.group", {}, reset));
    this.setMode("perspective");
  }

  setMode(mode: Mode): void {
    for (const [name, button] of Object.entries(this.modes)) button.setAttribute("aria-pressed", String(name === mode));
  }
}

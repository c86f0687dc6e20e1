// Light or dark: as the editor around the page is, else as the system wants it.

const DARK = ["vscode-dark", "vscode-high-contrast"];

export class Theme {
  private readonly wish = matchMedia("(prefers-color-scheme: dark)");
  private readonly watchers: (() => void)[] = [];

  constructor() {
    this.wish.addEventListener("change", () => this.apply());
    new MutationObserver(() => this.apply()).observe(document.body, { attributeFilter: ["class"] });
    this.apply();
  }

  /** `changed` is called whenever it turns. */
  watch(changed: () => void): void {
    this.watchers.push(changed);
  }

  get dark(): boolean {
    const { classList } = document.body;
    const inEditor = [...classList].some((name) => name.startsWith("vscode-"));
    return inEditor ? DARK.some((name) => classList.contains(name)) && !classList.contains("vscode-high-contrast-light") : this.wish.matches;
  }

  private apply(): void {
    document.documentElement.dataset["theme"] = this.dark ? "dark" : "light";
    for (const changed of this.watchers) changed();
  }
}

// The page with layouts side by side. Knows nothing of the editor.

import type { Alternative } from "./protocol.js";

/** The page; plans are images, in which nothing runs. */
export function alternativesPage(all: readonly Alternative[], nonce: string): string {
  const card = ({ seed, holds, total, plan }: Alternative) => {
    const picture = plan === null ? "<span>This layout has no plan.</span>" : `<img alt="Plan of the layout of seed ${seed}" src="data:image/svg+xml;base64,${Buffer.from(plan).toString("base64")}">`;
    return `<button data-seed="${seed}">${picture}<b>${holds === total ? "Everything holds" : `${holds} of ${total} hold`}</b><small>seed ${seed}</small></button>`;
  };
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'">
<title>Alternatives</title>
<style nonce="${nonce}">
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: 1rem; padding: 1rem 0; }
button { display: grid; gap: 0.4rem; padding: 0.6rem; text-align: left; font: inherit; cursor: pointer; border-radius: 6px;
  color: var(--vscode-foreground); background: var(--vscode-editorWidget-background); border: 1px solid var(--vscode-widget-border, transparent); }
button:hover, button:focus-visible { outline: 2px solid var(--vscode-focusBorder); }
img { width: 100%; aspect-ratio: 4 / 3; object-fit: contain; background: #fff; border-radius: 4px; }
</style>
</head>
<body>
<p>Choose a layout. It replaces the one that is there; undo brings that back.</p>
<main>${all.map(card).join("")}</main>
<script nonce="${nonce}">
const editor = acquireVsCodeApi();
for (const button of document.querySelectorAll("button")) button.addEventListener("click", () => editor.postMessage({ seed: Number(button.dataset.seed) }));
</script>
</body>
</html>
`;
}

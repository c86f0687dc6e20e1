// The page without the 3D viewer: the plan, and every constraint with its margin. Pressing a constraint marks its
// objects in the plan; pressing an object keeps only the constraints that speak of it.
(() => {
  "use strict";
  const data = JSON.parse(document.getElementById("scenelang-data").textContent);
  const rows = data.report.constraints;
  const make = (tag, attributes, ...children) => {
    const node = document.createElement(tag);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    node.append(...children);
    return node;
  };
  const ofRow = (row) => {
    const own = data.objects.filter((o) => rows[row].objects.some((n) => n === o.name || o.name.startsWith(n + "[")));
    return (own.length > 0 ? own : data.objects.filter((o) => o.constraints.includes(row))).map((o) => o.name);
  };
  const verdict = (row) => (row.satisfied === null ? ["doubt", "?"] : row.satisfied ? ["good", "✓"] : row.kind === "prefer" ? ["doubt", "✗"] : ["bad", "✗"]);
  const margin = (row) => {
    if (typeof row.margin !== "number") return "";
    const sign = row.margin < 0 ? "−" : "+";
    return sign + Math.abs(row.margin).toFixed(row.unit === "deg" ? 1 : 3) + (row.unit === "deg" ? "°" : " m");
  };

  let chosen = null;
  let object = null;
  const plan = make("section", { class: "plan", "aria-label": "Plan" });
  plan.innerHTML = data.plan;
  const sheet = plan.querySelector("svg");
  const list = make("ul", { class: "list" });
  const buttons = rows.map((row, index) => {
    const [tone, sign] = verdict(row);
    const about = row.kind === "assert" ? row.id : `${row.id} · ${row.kind}`;
    const button = make("button", { type: "button", "aria-pressed": "false", title: row.message || "" },
      make("span", { class: tone }, sign),
      make("span", {}, make("code", {}, row.text || row.message || row.id), make("small", {}, about)),
      make("span", { class: `margin ${tone}` }, margin(row)));
    button.addEventListener("click", () => { chosen = chosen === index ? null : index; show(); });
    list.append(make("li", {}, button));
    return button;
  });
  plan.addEventListener("click", (event) => {
    const hit = event.target.closest("[data-object]");
    object = hit && hit.dataset.object !== object ? hit.dataset.object : null;
    chosen = null;
    show();
  });
  const failed = rows.filter((row) => row.satisfied === false && row.kind !== "prefer").length;
  const summary = `${data.objects.length} objects, ${rows.length} constraints listed, ` + (failed === 0 ? "all hold" : `${failed} fail`);
  const hint = make("p", { class: "hint" }, "The 3D view is not part of this build of scenelang. To have it, run ",
    make("code", {}, "npm ci && npm run build"), " in ", make("code", {}, "viewer/"), ", build scenelang again and export again.");
  hint.style.margin = "0";
  const head = make("header", { class: "head" }, make("h1", {}, data.name), make("p", { class: failed ? "bad" : "good" }, summary));
  document.getElementById("fallback").replaceChildren(
    make("div", { class: "page" }, plan, make("aside", { class: "side", "aria-label": "Constraints" }, head, hint, list)));

  function show() {
    const names = chosen !== null ? ofRow(chosen) : object !== null ? [object] : [];
    if (sheet) sheet.classList.toggle("choosing", names.length > 0);
    for (const node of plan.querySelectorAll("[data-object]")) node.classList.toggle("hit", names.includes(node.dataset.object));
    const own = object === null ? null : data.objects.find((o) => o.name === object);
    buttons.forEach((button, index) => {
      button.setAttribute("aria-pressed", String(index === chosen));
      button.parentElement.hidden = own !== null && own !== undefined && !own.constraints.includes(index);
    });
  }
  document.title = `${data.name} — READY 0`;
})();

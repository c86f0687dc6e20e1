// A page as the exporter makes it, of two rooms and a dozen objects, without the exporter. Run by itself it writes
// the page to the path given (default: dist/fixture.html).
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import { box, cylinder, Glb } from "./glb.mjs";

const WOOD = "#b98a5e";
const DARK_WOOD = "#7a5638";
const STEEL = "#9aa0a8";
const HEIGHT = 2.7;
const ETA = 0.03;

const at = (shape, pos, colour, more = {}) => ({ shape, pos, colour, ...more });

/** Families of furniture: parts in the object's own frame for its size. */
const FAMILIES = {
  table: ([w, h, d], c = WOOD) => [at(box([w, 0.04, d]), [0, h - 0.02, 0], c), ...legs(w - 0.12, h - 0.04, d - 0.12, 0.06, DARK_WOOD)],
  chair: ([w, h, d], c = "#3f6f8f") => [
    at(box([w, 0.06, d]), [0, 0.43, 0], c),
    at(box([w, h - 0.46, 0.05]), [0, (h + 0.46) / 2, -d / 2 + 0.025], c),
    ...legs(w - 0.06, 0.4, d - 0.06, 0.04, STEEL),
  ],
  cabinet: ([w, h, d], c = "#e8e2d6") => [
    at(box([w, h - 0.06, d]), [0, (h + 0.06) / 2, 0], c),
    at(box([w - 0.1, 0.06, d - 0.06]), [0, 0.03, 0], "#3b3b3b"),
    at(box([0.01, h * 0.6, 0.02]), [0, h / 2, d / 2], "#55504a"),
  ],
  plant: ([w, h]) => [
    at(cylinder(w * 0.25, h * 0.3, w * 0.34), [0, h * 0.15, 0], "#c4704b"),
    at(cylinder(0.02, h * 0.3), [0, h * 0.4, 0], DARK_WOOD),
    at(cylinder(w * 0.5, h * 0.3, w * 0.3, 9), [0, h * 0.6, 0], "#4f8a4c"),
    at(cylinder(w * 0.42, h * 0.27, w * 0.05, 9), [0, h * 0.865, 0], "#5f9d58"),
  ],
  lamp: ([w, h]) => [
    at(cylinder(w * 0.45, 0.03), [0, 0.015, 0], STEEL, { metallic: 0.6, roughness: 0.4 }),
    at(cylinder(0.015, h - 0.3), [0, h / 2, 0], STEEL, { metallic: 0.6, roughness: 0.4 }),
    at(cylinder(w / 2, 0.3, w * 0.35), [0, h - 0.15, 0], "#f2e3bd"),
  ],
  screen: ([w, h, d]) => [at(box([w, h, d]), [0, h / 2, 0], "#1c1f24", { roughness: 0.35 })],
  door: ([w, h, d]) => [at(box([w, h, d]), [0, h / 2, 0], "#a9744a"), at(cylinder(0.02, 0.12), [w / 2 - 0.08, 1, d / 2 + 0.02], STEEL)],
  sofa: ([w, h, d], c = "#8a6f9e") => [
    at(box([w, 0.3, d]), [0, 0.22, 0], c),
    at(box([w, h - 0.3, 0.2]), [0, (h + 0.3) / 2, -d / 2 + 0.1], c),
    at(box([0.16, 0.55, d]), [-w / 2 + 0.08, 0.335, 0], c),
    at(box([0.16, 0.55, d]), [w / 2 - 0.08, 0.335, 0], c),
  ],
};

function legs(w, h, d, thick, colour) {
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, z]) => at(box([thick, h, thick]), [(x * w) / 2, h / 2, (z * d) / 2], colour));
}

const REGIONS = [
  { name: "meeting", vertices: [[0, 0], [5.2, 0], [5.2, 4.2], [0, 4.2]], floor: 0, ceiling: HEIGHT, floorColour: "#cfa878", wall: "#eeeae2" },
  { name: "lounge", vertices: [[5.26, 0], [8.4, 0], [8.4, 4.2], [5.26, 4.2]], floor: 0, ceiling: HEIGHT, floorColour: "#a7aeb5", wall: "#dfe6ea" },
];

const OBJECTS = [
  ["table", "table", [2.6, 0, 2.1], 0, [2.4, 0.74, 1.1]],
  ...[[1.8, 1.25, 0], [2.6, 1.25, 0], [3.4, 1.25, 0], [1.8, 2.95, 180], [2.6, 2.95, 180], [3.4, 2.95, 180]].map(([x, z, yaw], i) => [`chair[${i}]`, "chair", [x, 0, z], yaw, [0.48, 0.86, 0.5]]),
  ["sideboard", "cabinet", [0.26, 0, 2.1], 90, [1.8, 0.8, 0.44]],
  ["screen", "screen", [2.6, 1.1, 4.15], 180, [1.6, 0.9, 0.06]],
  ["plant", "plant", [4.78, 0, 3.75], 0, [0.6, 1.3, 0.6]],
  ["lamp", "lamp", [4.85, 0, 0.4], 0, [0.4, 1.6, 0.4]],
  ["vase", "plant", [2.5, 0.74, 2.1], 0, [0.22, 0.4, 0.22]],
  ["door", "door", [5.23, 0, 1.6], 90, [0.9, 2.05, 0.06]],
  ["sofa", "sofa", [7.3, 0, 3.65], 180, [1.9, 0.8, 0.9]],
  ["coffee", "table", [7.2, 0, 2.5], 0, [1.0, 0.42, 0.6]],
];

/** What moves: the front of the sideboard, hung on its left. */
const JOINTS = {
  sideboard: [{ name: "door", motion: "hinge", axis: [0, -1, 0], anchor: [-0.9, 0, 0.23], amount: 90, blocked: false, swept: [[-0.9, 0.23], [0.9, 0.23], [0.37, 1.5], [-0.9, 2.03]] }],
};
const LEAVES = { sideboard: [{ tag: { of: "sideboard", joint: "door" }, parts: [at(box([1.8, 0.74, 0.02]), [0, 0.43, 0.23], "#d9c9a8")] }] };

const ROWS = [
  ["assert", true, 0.001, "m", ["table", "meeting"], "inside(table, meeting)", ""],
  ["assert", true, 0.35, "m", ["chair[2]", "table"], "forall c in chair: gap(c, table) >= 10cm", ""],
  ["assert", true, 12.4, "deg", ["chair[0]", "table"], "forall c in chair: facing(c, table)", "`chair[0]` faces `table` within 30°"],
  ["assert", true, 0.01, "m", ["sideboard", "meeting"], "againstWall(sideboard, meeting)", ""],
  ["assert", true, null, null, ["door", "meeting", "lounge"], "connects(door, meeting, lounge)", ""],
  ["assert", false, -0.12, "m", ["lamp", "plant"], "distance(lamp, plant) <= 3.2", "the distance between `lamp` and `plant` is 3.35 m; at most 3.20 m was asked for"],
  ["assert", true, 0.02, "m", ["vase", "table"], "on(vase, table)", ""],
  ["assert", null, null, null, ["sofa"], "visible(sofa, screen)", "could not be checked: `monitor` is not in the layout"],
  ["prefer", false, -0.4, "m", ["coffee", "sofa"], "near(coffee, sofa, 60cm) weight 2", "the gap is 1.00 m"],
  ["prefer", true, 0.3, "m", ["plant", "meeting"], "inCorner(plant, meeting)", ""],
  ["pin", true, 0.001, "m", ["table"], "table.scale <- vec3(2.4, 0.74, 1.1)", ""],
  ["collision", false, -0.035, "m", ["plant", "screen"], "not collides(plant, screen)", "`plant` and `screen` overlap by 0.036 m", "P-COLLIDE"],
  ["support", true, 0.001, "m", ["sofa"], "supported(sofa)", "", "P-SUPPORT"],
];

/** The data of the fixture, as the exporter would put it into a page. */
export function fixtureData() {
  const constraints = ROWS.map(([kind, satisfied, margin, unit, objects, text, message, rule = null], i) => ({
    id: rule === null ? `meeting.scene:${i + 20}:1` : `${rule}:${objects.join(":")}`,
    kind, rule, code: rule === null ? "V0101" : "V0102", satisfied, margin, unit, objects, text, message,
    span: rule === null ? { file: "meeting.scene", start: [i + 20, 1], end: [i + 20, 10] } : null,
  }));
  const tally = (...kinds) => {
    const rows = constraints.filter(({ kind }) => kinds.includes(kind));
    return { total: rows.length, satisfied: rows.filter(({ satisfied }) => satisfied === true).length };
  };
  // A copy: a test may change what it is given.
  return structuredClone({
    format: "scenelang.preview/1",
    name: "meeting",
    glb: fixtureGlb().toString("base64"),
    plan: plan(),
    report: {
      format: "scenelang.report/1", file: "meeting.layout.json", ok: false,
      summary: { assertions: tally("assert"), preferences: tally("prefer"), physical: { total: 31, satisfied: 30 }, pins: tally("pin") },
      constraints,
      diagnostics: [{ code: "W0301", severity: "warning", message: "`vase` has no known category; a rounded box stands for it", span: null, related: [], fixes: [] }],
    },
    objects: OBJECTS.map(([name, category, pos, yaw, scale]) => ({
      name, label: name, category, pos, rot: [0, yaw, 0], scale,
      constraints: constraints.flatMap(({ objects }, i) => (objects.includes(name) ? [i] : [])),
      ...(JOINTS[name] === undefined ? {} : { joints: JOINTS[name] }),
    })),
    regions: REGIONS.map(({ name, vertices, floor, ceiling }) => ({ name, vertices, floor, ceiling })),
  });
}

/** The same room as a source sends it that sends it again: everything at the origin, and a name for what it looks like. */
export function shapedData() {
  return { ...fixtureData(), shape: "fixture", glb: fixtureGlb(true).toString("base64") };
}

function fixtureGlb(bare = false) {
  const glb = new Glb();
  for (const { name, vertices, floor, ceiling, floorColour, wall } of REGIONS) {
    const [[x0, z0], , [x1, z1]] = vertices;
    const [cx, cz] = [(x0 + x1) / 2, (z0 + z1) / 2];
    const plate = (y, colour) => [at(box([x1 - x0 + 2 * ETA, ETA, z1 - z0 + 2 * ETA]), [cx, y, cz], colour)];
    glb.add({ region: name, part: "floor" }, [0, 0, 0], 0, plate(floor - ETA / 2, floorColour));
    glb.add({ region: name, part: "ceiling" }, [0, 0, 0], 0, plate(ceiling + ETA / 2, "#ffffff"));
    const across = [x1 - x0 + 2 * ETA, ceiling - floor, ETA];
    for (const z of [z0 - ETA / 2, z1 + ETA / 2]) glb.add({ region: name, part: "wall" }, [cx, (floor + ceiling) / 2, z], 0, [at(box(across), [0, 0, 0], wall)]);
    // The other two walls are one node, as an exporter may do that joins what has one material.
    glb.add({ region: name, part: "wall" }, [0, 0, 0], 0, [x0 - ETA / 2, x1 + ETA / 2].flatMap((x) => sideWall(name, x, z0, z1, floor, ceiling).map(([size, pos]) => at(box(size), pos, wall))));
  }
  for (const [name, category, pos, yaw, scale] of OBJECTS) glb.add({ id: name }, bare ? [0, 0, 0] : pos, bare ? 0 : yaw, FAMILIES[category](scale), LEAVES[name]);
  return glb.finish();
}

/** A wall along z, with the opening of the door where it has one. */
function sideWall(region, x, z0, z1, floor, ceiling) {
  const slab = (from, to, low, high) => [[ETA, high - low, to - from], [x, (low + high) / 2, (from + to) / 2]];
  const shared = Math.abs(x - 5.23) < 0.05;
  return shared ? [slab(z0, 1.15, floor, ceiling), slab(2.05, z1, floor, ceiling), slab(1.15, 2.05, 2.05, ceiling)] : [slab(z0, z1, floor, ceiling)];
}

function plan() {
  const shapes = OBJECTS.map(([name, , [x, , z], yaw, [w, , d]]) => `<g transform="translate(${x} ${-z}) rotate(${yaw})"><rect x="${-w / 2}" y="${-d / 2}" width="${w}" height="${d}" fill="#dde6f3" stroke="#345" stroke-width="0.02"/><title>${name}</title></g>`);
  const rooms = REGIONS.map(({ vertices }) => `<polygon points="${vertices.map(([x, z]) => `${x},${-z}`).join(" ")}" fill="#fff" stroke="#222" stroke-width="0.06"/>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-0.3 -4.5 9 4.8">${rooms.join("")}${shapes.join("")}</svg>`;
}

/** A whole page, as strict about its content as a webview would be. */
export function page(data, script) {
  const json = JSON.stringify(data).replaceAll("<", "\\u003c");
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>${data.name ?? "broken"}</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'nonce-fixture'; style-src 'none'; img-src data:">
</head><body><main id="scenelang"></main><div id="fallback">static fallback</div>
<script type="application/json" id="scenelang-data">${json}</script>
<script nonce="fixture">${script}</script></body></html>`;
}

export const bundle = () => readFileSync(fileURLToPath(new URL("../dist/viewer.js", import.meta.url)), "utf8");

if (process.argv[1] !== undefined && import.meta.url === pathToFileURL(process.argv[1]).href)
  writeFileSync(process.argv[2] ?? fileURLToPath(new URL("../dist/fixture.html", import.meta.url)), page(fixtureData(), bundle()));

// Links: what one holds comes back; whatever else an address may have is refused with a reason.
import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import { load } from "./load.mjs";

const { decode, encode, nameOf } = await load("link.ts");
const packed = (value) => `#p=${deflateRawSync(typeof value === "string" ? value : JSON.stringify(value)).toString("base64url")}`;

test("a program comes back as it was", async () => {
  for (const text of ["", "object desk;\n", "// 🪑 naïve </script>\r\n", "x".repeat(40_000), "object a;\n".repeat(5_000)]) {
    const fragment = await encode({ name: "my room.scene", text });
    assert.match(fragment, /^#p=[A-Za-z0-9_-]+$/);
    assert.deepEqual(await decode(fragment), { name: "my room.scene", text });
  }
});

test("no fragment is no program", async () => {
  for (const fragment of ["", "#"]) assert.equal(await decode(fragment), null);
});

test("what no page has made is refused", async () => {
  const refused = [
    ["#else", /not a link/],
    ["#<script>alert(1)</script>", /not a link/],
    ["#p=", /characters/],
    ["#p=<img src=x onerror=alert(1)>", /characters/],
    ["#p=%3Cscript%3E", /characters/],
    ["#p=AAAA", /damaged/],
    [`#p=${"A".repeat(300_000)}`, /too long/],
    [packed("no JSON"), /damaged/],
    [packed(Buffer.from([0x22, 0xff, 0x22]).toString("latin1")), /program|damaged/],
    [packed({ name: "a", text: "b" }), /no program/],
    [packed(["a.scene", 3]), /no program/],
    [packed(["a.scene", "b", "c"]), /no program/],
    [packed(null), /no program/],
    // A bomb: 100 MB of zeros are 100 kB.
    [packed("0".repeat(100_000_000)), /too large/],
  ];
  for (const [fragment, why] of refused) await assert.rejects(decode(fragment), why, fragment.slice(0, 60));
});

test("a program that is too long for a link has none", async () => {
  await assert.rejects(encode({ name: "a.scene", text: "x".repeat(1_000_000) }), /too long/);
});

test("names are names of files, and nothing else", () => {
  assert.equal(nameOf("study.scene"), "study.scene");
  assert.equal(nameOf("../../etc/passwd"), "-etc-passwd.scene");
  assert.equal(nameOf("<b>"), "-b-.scene");
  assert.equal(nameOf("…"), "room.scene");
  assert.equal(nameOf("Wohnküche 2.scene"), "Wohnküche 2.scene");
  assert.equal(nameOf("x".repeat(500)).length, 66);
});

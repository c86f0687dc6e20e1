// Packs the extension into a .vsix: a zip of its files and two lists that say what they are. With `--server FILE --target
// linux-x64` it holds the server too, for one platform; without, for all.
//
//   node package.mjs [OUT.vsix] [--server FILE --target PLATFORM]
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { zip } from "./zip.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** What is shipped; nothing else is. */
const SHIPPED = ["package.json", "README.md", "language-configuration.json", "dist", "media", "snippets", "syntaxes"];
const LICENCES = ["LICENSE-APACHE", "LICENSE-MIT", "LICENSE-WORDNET"];
const TYPES = { json: "application/json", md: "text/markdown", js: "application/javascript", svg: "image/svg+xml", png: "image/png", txt: "text/plain", exe: "application/octet-stream" };

const { values, positionals } = parseArgs({ allowPositionals: true, options: { server: { type: "string" }, target: { type: "string" } } });
if ((values.server === undefined) !== (values.target === undefined)) throw new Error("--server and --target belong together");
if (!existsSync(here("dist/extension.js"))) throw new Error("build first: npm run build");

const manifest = JSON.parse(readFileSync(here("package.json"), "utf8"));
// What only those need who work on it.
const { scripts, devDependencies, ...shipped } = manifest;

function* filesBelow(path) {
  if (statSync(here(path)).isDirectory()) for (const name of readdirSync(here(path)).sort()) yield* filesBelow(`${path}/${name}`);
  else yield path;
}

const files = SHIPPED.flatMap((path) => [...filesBelow(path)]).map((path) => ({
  name: `extension/${path}`,
  bytes: path === "package.json" ? Buffer.from(`${JSON.stringify(shipped, null, 2)}\n`) : readFileSync(here(path)),
}));
for (const name of LICENCES) files.push({ name: `extension/${name}.txt`, bytes: readFileSync(here(`../../${name}`)) });
if (values.server !== undefined) {
  const name = values.target.startsWith("win32") ? "scenelang.exe" : "scenelang";
  files.push({ name: `extension/server/${name}`, bytes: readFileSync(values.server), executable: true });
}

const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);
const asset = (type, path) => `    <Asset Type="Microsoft.VisualStudio.${type}" Path="${path}" Addressable="true"/>`;
const property = (id, value) => `      <Property Id="Microsoft.VisualStudio.${id}" Value="${escaped(value)}"/>`;
const list = `<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id="${manifest.name}" Version="${manifest.version}" Publisher="${manifest.publisher}"${values.target === undefined ? "" : ` TargetPlatform="${escaped(values.target)}"`}/>
    <DisplayName>${escaped(manifest.displayName)}</DisplayName>
    <Description xml:space="preserve">${escaped(manifest.description)}</Description>
    <Tags>${escaped(manifest.keywords.join(","))}</Tags>
    <Categories>${escaped(manifest.categories.join(","))}</Categories>
    <GalleryFlags>Public</GalleryFlags>
    <Properties>
${property("Code.Engine", manifest.engines.vscode)}
${property("Services.Links.Source", manifest.repository.url)}
    </Properties>
    <License>extension/LICENSE-APACHE.txt</License>
    <Icon>extension/${manifest.icon}</Icon>
  </Metadata>
  <Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation>
  <Dependencies/>
  <Assets>
${asset("Code.Manifest", "extension/package.json")}
${asset("Services.Content.Details", "extension/README.md")}
${asset("Services.Content.License", "extension/LICENSE-APACHE.txt")}
${asset("Services.Icons.Default", `extension/${manifest.icon}`)}
  </Assets>
</PackageManifest>
`;
const endings = [...new Set(files.map(({ name }) => /\.([^./]+)$/.exec(name)?.[1]).filter(Boolean)), "vsixmanifest"].sort();
const types = `<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
${endings.map((ending) => `  <Default Extension=".${ending}" ContentType="${TYPES[ending] ?? "text/xml"}"/>`).join("\n")}
</Types>
`;

const out = positionals[0] ?? here(`../../out/${manifest.name}.vsix`);
const packed = zip([{ name: "extension.vsixmanifest", bytes: Buffer.from(list) }, { name: "[Content_Types].xml", bytes: Buffer.from(types) }, ...files]);
mkdirSync(dirname(out), { recursive: true });
writeFileSync(out, packed);
console.log(`${out}: ${files.length} files, ${(packed.length / 1024).toFixed(0)} KiB`);

// Colours programs by a TextMate grammar as VS Code does, with its tokenizer and its regular expressions.
// usage: node textmate.mjs GRAMMAR.json FILE…      one line of JSON per file: [[first byte, one past the last, scope…]…]
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import oniguruma from "vscode-oniguruma";
import textmate from "vscode-textmate";

const [grammarPath, ...files] = process.argv.slice(2);
const wasm = createRequire(import.meta.url).resolve("vscode-oniguruma/release/onig.wasm");
await oniguruma.loadWASM(await readFile(wasm));
const source = await readFile(grammarPath, "utf8");
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => textmate.parseRawGrammar(source, grammarPath),
});
const grammar = await registry.loadGrammar(JSON.parse(source).scopeName);

for (const file of files) {
  // Bytes of a text, though scopes are given in UTF-16.
  const text = await readFile(file, "utf8");
  const bytes = (part) => Buffer.byteLength(part, "utf8");
  const found = [];
  let state = textmate.INITIAL;
  let start = 0;
  for (const [line] of text.matchAll(/[^\r\n]*(?:\r\n|\r|\n|$)/g)) {
    const content = line.replace(/[\r\n]+$/, "");
    const { tokens, ruleStack } = grammar.tokenizeLine(content, state);
    for (const { startIndex, endIndex, scopes } of tokens) {
      const first = start + bytes(content.slice(0, startIndex));
      found.push([first, first + bytes(content.slice(startIndex, endIndex)), ...scopes]);
    }
    state = ruleStack;
    start += bytes(line);
  }
  console.log(JSON.stringify(found));
}

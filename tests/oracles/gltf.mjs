// Judges GLB files with Khronos' glTF validator: any error or warning is a failure.
// usage: node gltf.mjs FILE.glb…      exit 0 clean, 1 findings, 2 unreadable
import { readFile } from "node:fs/promises";
import validator from "gltf-validator";

const SEVERITIES = ["error", "warning", "info", "hint"];
let worst = 0;

for (const path of process.argv.slice(2)) {
  let report;
  try {
    report = await validator.validateBytes(new Uint8Array(await readFile(path)), { uri: path, maxIssues: 0 });
  } catch (error) {
    console.error(`${path}: ${error}`);
    worst = 2;
    continue;
  }
  const { numErrors, numWarnings, messages } = report.issues;
  console.log(`${path}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalTriangleCount} triangles`);
  for (const { severity, code, pointer, message } of messages.filter((m) => m.severity <= 1)) {
    console.log(`  ${SEVERITIES[severity]} ${code} at ${pointer}: ${message}`);
  }
  if (numErrors + numWarnings > 0) worst = Math.max(worst, 1);
}
process.exit(worst);

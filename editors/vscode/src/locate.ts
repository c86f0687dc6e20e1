// Which `scenelang` program is the server: the one that comes with the extension, which is known to fit it, else the one that
// the user has set, else the one on the PATH; never one that a workspace names which is not trusted. Knows nothing of the editor.

import { delimiter, isAbsolute, join } from "node:path";

export interface Places {
  /** The setting of the user, and that of the workspace, which goes before it; empty: the PATH is to be used, `null`: not set. */
  readonly settings: { readonly user: string | null; readonly workspace: string | null };
  /** Whether the workspace may say what is run; if not, neither its setting is heard nor a file in it is meant. */
  readonly trusted: boolean;
  /** What a relative setting is relative to; `null`: no folder is open. */
  readonly workspace: string | null;
  /** The folder of the extension. */
  readonly extension: string;
  /** The variable PATH. */
  readonly path: string;
  readonly windows: boolean;
  /** Whether a file is there and may be run. */
  readonly runs: (file: string) => boolean;
}

export type Located = { readonly command: string; readonly from: "setting" | "extension" | "PATH" } | { readonly missing: string };

export function locate({ settings, trusted, workspace, extension, path, windows, runs }: Places): Located {
  const name = windows ? "scenelang.exe" : "scenelang";
  const bundled = join(extension, "server", name);
  if (runs(bundled)) return { command: bundled, from: "extension" };
  const setting = ((trusted ? settings.workspace : null) ?? settings.user ?? "").trim();
  if (setting !== "") {
    const absent = workspace === null ? "no folder is open" : trusted ? null : "the folder is not trusted";
    if (!isAbsolute(setting) && absent !== null) return { missing: `the setting scenelang.server.path is "${setting}", which is relative, and ${absent}` };
    const file = isAbsolute(setting) || workspace === null ? setting : join(workspace, setting);
    // Whoever sets it does not want another.
    return runs(file) ? { command: file, from: "setting" } : { missing: `the setting scenelang.server.path names ${file}, which is no program` };
  }
  // A relative entry would be looked up in whatever folder is open.
  const folders = path.split(delimiter).filter((folder) => isAbsolute(folder));
  const found = folders.map((folder) => join(folder, name)).find(runs);
  if (found !== undefined) return { command: found, from: "PATH" };
  return { missing: `there is no ${name} in the extension or on the PATH, and the setting scenelang.server.path names none` };
}

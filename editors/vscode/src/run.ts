// Running the command line: what it said, whether it ended well, and an end to it when it is no longer wanted. Knows nothing
// of the editor.

import { spawn } from "node:child_process";

export interface Ended {
  /** `null`: it was ended by a signal. */
  readonly code: number | null;
  readonly stdout: string;
  readonly stderr: string;
}

/** What a program says beyond this is dropped. */
const MOST = 16 << 20;
/** A program that was asked to end, and has not for so long (ms), is made to. */
const GRACE = 3000;

/** Rejects where the program cannot be started. */
export function run(command: string, args: readonly string[], cwd: string, signal: AbortSignal, env: NodeJS.ProcessEnv = process.env): Promise<Ended> {
  return new Promise((done, failed) => {
    const child = spawn(command, args, { cwd, env, stdio: ["ignore", "pipe", "pipe"], windowsHide: true });
    const said = { stdout: "", stderr: "" };
    for (const name of ["stdout", "stderr"] as const) {
      child[name].setEncoding("utf8");
      child[name].on("data", (text: string) => {
        if (said[name].length < MOST) said[name] += text;
      });
    }
    let last: NodeJS.Timeout | undefined;
    const end = () => {
      // As Ctrl-C does: it stops between two files, never within one.
      child.kill("SIGINT");
      last = setTimeout(() => child.kill("SIGKILL"), GRACE);
    };
    if (signal.aborted) end();
    else signal.addEventListener("abort", end, { once: true });
    const over = () => {
      clearTimeout(last);
      signal.removeEventListener("abort", end);
    };
    child.on("error", (error) => (over(), failed(error)));
    child.on("close", (code) => (over(), done({ code, ...said })));
  });
}

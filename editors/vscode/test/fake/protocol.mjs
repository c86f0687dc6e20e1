// JSON-RPC over standard input and output, as much of it as a test needs.

/** Calls `handle(method, params)` for every message; what it returns is the answer, what it throws an error. */
export function connect(handle) {
  const asked = new Map();
  let last = 0;
  let rest = Buffer.alloc(0);

  const write = (message) => {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    process.stdout.write(`Content-Length: ${body.length}\r\n\r\n`);
    process.stdout.write(body);
  };
  const notify = (method, params) => write({ method, params });
  const ask = (method, params) =>
    new Promise((done, failed) => {
      const id = `fake-${(last += 1)}`;
      asked.set(id, { done, failed });
      write({ id, method, params });
    });
  const hear = async ({ id, method, params, result, error }) => {
    if (method === undefined) {
      const { done, failed } = asked.get(id) ?? {};
      asked.delete(id);
      return error === undefined ? done?.(result) : failed?.(new Error(error.message));
    }
    try {
      const answer = await handle(method, params, { notify, ask });
      if (id !== undefined) write({ id, result: answer ?? null });
    } catch (why) {
      if (id !== undefined) write({ id, error: { code: why.code ?? -32603, message: why.message } });
    }
  };
  process.stdin.on("data", (chunk) => {
    rest = Buffer.concat([rest, chunk]);
    for (;;) {
      const head = rest.indexOf("\r\n\r\n");
      if (head < 0) return;
      const length = Number(/content-length: *(\d+)/i.exec(rest.subarray(0, head).toString())[1]);
      if (rest.length < head + 4 + length) return;
      const body = rest.subarray(head + 4, head + 4 + length).toString();
      rest = rest.subarray(head + 4 + length);
      void hear(JSON.parse(body));
    }
  });
  process.stdin.on("end", () => process.exit(0));
}

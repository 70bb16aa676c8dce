// The package in Chromium has the results of Node.
import assert from "node:assert/strict";
import { createReadStream, existsSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { test } from "node:test";
import { launch } from "../../viewer/test/browser.mjs";
import { folder, listed, polhode, REQUESTS } from "./package.mjs";

const KINDS = { ".js": "text/javascript", ".mjs": "text/javascript", ".wasm": "application/wasm", ".html": "text/html" };
const PAGE = `<!doctype html><script type="importmap">{"imports": {"polhode": "/node_modules/polhode/index.js"}}</script>`;

const server = createServer((request, response) => {
  const path = join(folder, normalize(new URL(request.url, "http://localhost").pathname));
  if (request.url === "/") response.setHeader("Content-Type", "text/html").end(PAGE);
  else if (existsSync(path)) createReadStream(path).pipe(response.setHeader("Content-Type", KINDS[extname(path)] ?? "text/plain"));
  else response.writeHead(404).end();
});

test("all functions have the results of Node", async () => {
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const browser = await launch();
  try {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    for (const [name, request] of REQUESTS) {
      const found = await page.evaluate(
        async ([name, request]) => {
          const polhode = await import("polhode");
          const result = await polhode[name](request);
          return JSON.parse(JSON.stringify(result, (_, inner) => (ArrayBuffer.isView(inner) ? [...inner] : inner)));
        },
        [name, request],
      );
      assert.deepEqual(found, listed(await polhode[name](request)), name);
    }
    const refused = await page.evaluate(async () => {
      const { inertia, PolhodeError } = await import("polhode");
      return inertia({ box: "1 m, 2 m, 3 m" }).catch((error) => [error instanceof PolhodeError, error.reason]);
    });
    assert.equal(refused[0], true);
  } finally {
    await browser.close();
    server.close();
  }
});

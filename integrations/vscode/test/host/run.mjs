// Runs suite.cjs in the extension host of VS Code.
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { extension, install, start } from "./host.mjs";

/** Longest time of the tests, ms. */
const LIMIT = 240_000;

install();
const folder = mkdtempSync(join(tmpdir(), "polhode-workspace-"));
for (const name of ["robots/bad-arm.urdf", "robots/arm.sdf", "t-handle.toml", "bracket.toml", "bracket.stl"]) {
  cpSync(resolve(extension, "../../examples", name), join(folder, name.split("/").at(-1)));
}
cpSync(resolve(extension, "../../Cargo.toml"), join(folder, "Cargo.toml"));
writeFileSync(join(folder, "page.toml"), "[head]\nmas = 1\n[body]\nmas = 2\n");
const { page, address, stop } = await start(folder, [["extensionTestsPath", join(extension, "test/host/suite.cjs")]]);
try {
  const ended = new Promise((done, failed) => {
    setTimeout(() => failed(new Error(`the tests take longer than ${LIMIT / 1000} s`)), LIMIT).unref();
    page.exposeFunction("codeAutomationLog", (_, [line]) => {
      const [, own] = /^polhode: ([^]*)/.exec(line) ?? [];
      if (own !== undefined) console.log(own);
    });
    page.exposeFunction("codeAutomationExit", done);
  });
  await page.goto(address);
  process.exitCode = await ended;
} finally {
  await stop();
  rmSync(folder, { recursive: true, force: true });
}

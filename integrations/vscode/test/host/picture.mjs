// Draws the picture of the README: node test/host/picture.mjs OUT.png.
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { extension, install, start } from "./host.mjs";

install();
const folder = mkdtempSync(join(tmpdir(), "robot-"));
cpSync(resolve(extension, "../../examples/robots/bad-arm.urdf"), join(folder, "bad-arm.urdf"));
const { page, address, stop } = await start(folder, [["openFile", join(folder, "bad-arm.urdf")]]);
try {
  await page.goto(address);
  await page.waitForSelector(".squiggly-error", { timeout: 60_000 });
  await page.waitForTimeout(3000);
  await page.screenshot({ path: process.argv[2] });
} finally {
  await stop();
  rmSync(folder, { recursive: true, force: true });
}

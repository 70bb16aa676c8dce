// Draws the picture of the README: node test/host/picture.mjs OUT.png.
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { extension, install, start } from "./host.mjs";

install();
const folder = mkdtempSync(join(tmpdir(), "robot-"));
cpSync(resolve(extension, "../../examples/robots/bad-arm.urdf"), join(folder, "bad-arm.urdf"));
const settings = { "editor.minimap.enabled": false, "workbench.activityBar.location": "hidden", "workbench.layoutControl.enabled": false, "editor.fontSize": 13 };
const { page, address, stop } = await start(folder, [["openFile", join(folder, "bad-arm.urdf")]], settings);
try {
  await page.goto(address);
  await page.waitForSelector(".squiggly-error", { timeout: 60_000 });
  await page.keyboard.press("Control+b");
  await page.keyboard.press("Control+g");
  await page.keyboard.type("24:60\n");
  await page.keyboard.press("Control+Shift+m");
  await page.waitForTimeout(2000);
  await page.locator(".view-line span span", { hasText: "7020E-3" }).last().hover();
  await page.waitForSelector(".monaco-hover:not(.hidden)");
  await page.waitForTimeout(1000);
  // Without the title bar, which has the name of the temporary folder.
  await page.screenshot({ path: process.argv[2], clip: { x: 0, y: 35, width: 1100, height: 665 } });
} finally {
  await stop();
  rmSync(folder, { recursive: true, force: true });
}

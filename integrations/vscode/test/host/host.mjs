// VS Code without a window: the server of code-server, and its workbench in Chromium.
import { execFileSync, spawn } from "node:child_process";
import { copyFileSync, cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const here = dirname(fileURLToPath(import.meta.url));
export const extension = resolve(here, "../..");
const installed = join(extension, ".host");
const code = join(installed, "node_modules/code-server/lib/vscode");

/** Installs VS Code from the npm registry: 60 MB. No install script is run, and no native module is compiled. */
export function install() {
  if (existsSync(join(code, "node_modules/@vscode/ripgrep/bin"))) return;
  rmSync(installed, { recursive: true, force: true });
  mkdirSync(installed);
  for (const file of ["package.json", "package-lock.json"]) copyFileSync(join(here, file), join(installed, file));
  const words = ["--ignore-scripts", "--omit=dev", "--no-audit", "--no-fund", "--silent"];
  execFileSync("npm", ["ci", ...words], { cwd: installed, stdio: "inherit" });
  // Its npm-shrinkwrap.json pins the versions, but npm ci refuses it.
  execFileSync("npm", ["install", ...words], { cwd: code, stdio: "inherit" });
  // Its own search program would be downloaded by an install script.
  cpSync(join(installed, `node_modules/@vscode/ripgrep-${process.platform}-${process.arch}/bin`), join(code, "node_modules/@vscode/ripgrep/bin"), { recursive: true });
}

/** Starts VS Code with the extension on a folder. `payload` are further parameters of the workbench. */
export async function start(folder, payload = [], settings = {}) {
  const scratch = mkdtempSync(join(tmpdir(), "polhode-vscode-"));
  mkdirSync(join(scratch, "data/Machine"), { recursive: true });
  writeFileSync(join(scratch, "data/Machine/settings.json"), JSON.stringify(settings));
  const words = ["--host", "127.0.0.1", "--port", "0", "--without-connection-token", "--accept-server-license-terms", "--disable-workspace-trust", "--telemetry-level", "off"];
  // The variables of this process, such as NODE_OPTIONS, are not the server's.
  const server = spawn(process.execPath, [join(code, "out/server-main.js"), ...words, "--server-data-dir", scratch, "--extensions-dir", join(scratch, "extensions")], { stdio: ["ignore", "pipe", "ignore"] });
  const port = await new Promise((done, failed) => {
    let text = "";
    server.stdout.on("data", (data) => {
      text += data;
      const port = /listening on (\d+)/.exec(text)?.[1];
      if (port) done(port);
    });
    server.on("exit", () => failed(new Error(`VS Code did not start:\n${text}`)));
  });
  const browser = await chromium.launch({ executablePath: executable(), args: ["--no-sandbox", "--disable-gpu"] });
  const page = await (await browser.newContext({ viewport: { width: 1100, height: 700 } })).newPage();
  const stop = async () => {
    await browser.close();
    server.removeAllListeners("exit").kill();
    rmSync(scratch, { recursive: true, force: true, maxRetries: 5 });
  };
  const remote = (path) => `vscode-remote://127.0.0.1:${port}${path}`;
  const parameters = [["extensionDevelopmentPath", remote(extension)], ["skipWelcome", "true"], ["skipReleaseNotes", "true"], ...payload.map(([key, path]) => [key, remote(path)])];
  const address = `http://127.0.0.1:${port}/?folder=${folder}&payload=${encodeURIComponent(JSON.stringify(parameters))}`;
  return { page, address, stop };
}

function executable() {
  const names = ["chromium", "chromium-browser", "google-chrome"];
  const places = (process.env.PATH ?? "").split(":").flatMap((place) => names.map((name) => join(place, name)));
  const found = process.env.CHROMIUM ?? places.find(existsSync);
  if (!found) throw new Error("no Chromium is on PATH; name one in CHROMIUM");
  return found;
}

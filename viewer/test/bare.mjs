// Chromium without Playwright, whose watching of the network makes every request some ms slower: a page is opened, and scripts run in it.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ARGUMENTS, executable } from "./browser.mjs";

/** A browser of one page; `script` runs before the page's own. */
export async function bare(script) {
  const folder = mkdtempSync(join(tmpdir(), "polhode-bare-"));
  const args = [...ARGUMENTS, "--headless=new", "--no-first-run", "--window-size=460,420", "--force-prefers-reduced-motion", "--remote-debugging-pipe", `--user-data-dir=${folder}`];
  const child = spawn(executable(), [...args, "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [, , , asks, answers] = child.stdio;
  const waiting = new Map();
  let held = "";
  answers.setEncoding("utf8").on("data", (text) => {
    const messages = (held + text).split("\0");
    held = messages.pop();
    for (const { id, result, error } of messages.map((message) => JSON.parse(message))) {
      if (error) waiting.get(id)?.fail(new Error(error.message));
      else waiting.get(id)?.done(result);
      waiting.delete(id);
    }
  });
  let [count, sessionId] = [0, undefined];
  const send = (method, params = {}) =>
    new Promise((done, fail) => {
      waiting.set((count += 1), { done, fail });
      asks.write(`${JSON.stringify({ id: count, method, params, sessionId })}\0`);
    });
  const { targetInfos } = await send("Target.getTargets");
  ({ sessionId } = await send("Target.attachToTarget", { targetId: targetInfos.find(({ type }) => type === "page").targetId, flatten: true }));
  await send("Page.enable");
  await send("Page.addScriptToEvaluateOnNewDocument", { source: `(${script})()` });
  const evaluate = async (call, argument) => {
    const expression = `(${call})(${JSON.stringify(argument) ?? ""})`;
    const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  return {
    send,
    evaluate,
    /** Opens a page, and waits until it is so. */
    goto: async (url, isThere) => {
      await send("Page.navigate", { url });
      while (!(await evaluate(isThere))) await new Promise((done) => setTimeout(done, 100));
    },
    close: async () => {
      const ended = new Promise((done) => child.on("exit", done));
      child.kill();
      await ended;
      rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

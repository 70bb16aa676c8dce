// `polhode live`, as the tests start it: POLHODE names the program, else it is the one that cargo has built.
import { spawn } from "node:child_process";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
/** The command. */
export const program = process.env.POLHODE ?? resolve(root, "target/debug/polhode");

export const example = (name) => resolve(root, "examples", name);

/** Serves these files; gives the page's address. */
export function serve(...files) {
  const child = spawn(program, ["live", ...files, "--no-open", "--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
  return new Promise((done, fail) => {
    let said = "";
    child.on("error", fail);
    child.on("exit", (code) => fail(new Error(`${program} ended with ${code}: ${said}`)));
    child.stdout.on("data", (text) => {
      said += text;
      const [address] = /http:\/\/127\.0\.0\.1:\d+\/\S*/.exec(said) ?? [];
      if (address) done({ address, close: () => child.kill() });
    });
  });
}

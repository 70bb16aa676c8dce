// The interactive page of the tests: POLHODE_PAGE names it, else it is the one that `cargo xtask page` has built.
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const path = process.env.POLHODE_PAGE ?? resolve(dirname(fileURLToPath(import.meta.url)), "../../target/page/polhode.html");

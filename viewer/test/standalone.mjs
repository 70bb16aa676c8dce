// The interactive page of the tests: POLHODE_PAGE names it, else it is the one that `cargo xtask page` has built.
import { readFileSync } from "node:fs";
import { dirname, resolve } from "node:path";
import { fileURLToPath } from "node:url";

export const path = process.env.POLHODE_PAGE ?? resolve(dirname(fileURLToPath(import.meta.url)), "../../target/page/polhode.html");

/** The page as text, and the bytes of a page: UTF-16 with a byte order mark. */
export const read = () => readFileSync(path, "utf16le").slice(1);
export const bytesOf = (text) => Buffer.from(`\ufeff${text}`, "utf16le");

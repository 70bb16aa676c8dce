// node mathjax.mjs FILE.md …: MathJax sets every formula between lines of $$, or this fails.
import { readFileSync } from "node:fs";
import { liteAdaptor } from "mathjax-full/js/adaptors/liteAdaptor.js";
import { RegisterHTMLHandler } from "mathjax-full/js/handlers/html.js";
import { TeX } from "mathjax-full/js/input/tex.js";
import "mathjax-full/js/input/tex/ams/AmsConfiguration.js";
import "mathjax-full/js/input/tex/base/BaseConfiguration.js";
import "mathjax-full/js/input/tex/boldsymbol/BoldsymbolConfiguration.js";
import { mathjax } from "mathjax-full/js/mathjax.js";
import { CHTML } from "mathjax-full/js/output/chtml.js";

const adaptor = liteAdaptor();
RegisterHTMLHandler(adaptor);
const problems = [];
const input = new TeX({
  packages: ["base", "ams", "boldsymbol"],
  formatError: (_, error) => {
    throw error;
  },
});
const set = mathjax.document("", { InputJax: input, OutputJax: new CHTML() });

let count = 0;
for (const file of process.argv.slice(2)) {
  for (const [, latex] of readFileSync(file, "utf8").matchAll(/^\$\$\n([^]*?)\n\$\$$/gm)) {
    count += 1;
    try {
      set.convert(latex, { display: true });
    } catch (error) {
      problems.push(`${file}: ${error.message}\n${latex}`);
    }
  }
}
if (count === 0) problems.push("no formula");
for (const problem of problems) console.error(problem);
console.log(`   MathJax: ${count} formulas`);
process.exit(problems.length > 0 ? 1 : 0);

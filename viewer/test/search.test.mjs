// The book's search, book/site/search.js: what is found, and in which order.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { runInNewContext } from "node:vm";

const source = readFileSync(new URL("../../book/site/search.js", import.meta.url), "utf8");
const page = { document: { documentElement: { dataset: {} }, addEventListener: () => {} } };
runInNewContext(source, page);
const { build, find } = page.polhodeSearch;

const index = build([
  ["spin.html", "Free motion", "", "A body that is thrown and left alone."],
  ["spin.html#limits", "Free motion", "Limits", "Near the separatrix the period grows without bound, and the polhodes crowd together."],
  ["tops.html#sleeping", "Tops", "Sleeping tops", "Upright, and stable above a threshold."],
  ["CHANGELOG.html", "Changelog", "Added", "Sleeping tops, gyroscopes, and the separatrix."],
  ["plots.html#polhodes", "Plots", "Polhodes", "Curves on the sphere of L."],
  ["shapes.html", "Shapes", "", "Parallel edges, an axis of symmetry, and the density of steel, which has a density of 7850."],
  ["inertia.html", "Inertia", "", "The parallel-axis theorem moves a tensor; --density 2700 gives it a scale."],
]);
const places = (query) => Array.from(find(index, query), (k) => index.sections[k][0]);

test("a heading counts more than the text, and a page that only repeats less", () => {
  assert.deepEqual(places("polhodes"), ["plots.html#polhodes", "spin.html#limits"]);
  assert.deepEqual(places("sleeping"), ["tops.html#sleeping", "CHANGELOG.html"]);
  assert.deepEqual(places("separatrix"), ["spin.html#limits", "CHANGELOG.html"]);
});

test("the beginning of a word finds it, in any case", () => {
  assert.deepEqual(places("POLH"), places("polhodes"));
  assert.deepEqual(places("olhodes"), []);
});

test("words next to each other count more", () => {
  assert.deepEqual(places("parallel axis"), ["inertia.html", "shapes.html"]);
});

test("an option is found with its dashes, and without them as a word", () => {
  assert.deepEqual(places("--density"), ["inertia.html"]);
  assert.deepEqual(places("--den"), ["inertia.html"]);
  assert.deepEqual(places("density"), ["shapes.html", "inertia.html"]);
});

test("every word has to be there", () => {
  assert.deepEqual(places("free limits"), ["spin.html#limits"]);
  assert.deepEqual(places("sleeping separatrix"), ["CHANGELOG.html"]);
  assert.deepEqual(places("sleeping nutation"), []);
  assert.deepEqual(places(" -- "), []);
});

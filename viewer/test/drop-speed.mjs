// How long a mesh of 200,000 triangles takes from the drop until the body and what was found in it are shown, with `polhode live` itself: ms to
// the end of the calls that draw the frame, of which the answers to `drop`, `open` and what follows are so much, and the page the rest. Of a sound
// mesh, which moves, and of some that bound no solid. POLHODE names the program (build it with --release); arguments choose among the meshes. The
// calls of the GPU are made and draw nothing, as without one the pixels are computed in software. Not a test.
import { bare } from "./bare.mjs";
import { serve, example } from "./live-server.mjs";

const ROUNDS = 9;
const KINDS = ["sound", "hole", "flipped", "inside-out", "nested", "crossing", "twice", "cracked", "soup"];
const asked = process.argv.slice(2);
const server = await serve(example("t-handle.toml"));
const page = await bare(() => {
  for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) WebGL2RenderingContext.prototype[call] = () => undefined;
});
await page.goto(server.address, () => window.polhodeLive?.isSettled);
for (const kind of asked.length > 0 ? asked : KINDS) {
  const { rounds, count } = await page.evaluate(
    async ({ kind, rounds }) => {
      let seed = 1;
      const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
      /** An ellipsoid of n parts from pole to pole, and as many around. */
      const ellipsoid = (n, scale = 1, along = 0) => {
        const at = (i, j) => {
          const [theta, phi] = [(Math.PI * i) / n, (2 * Math.PI * (j % n)) / n];
          const ring = i === 0 || i === n ? [0, 0, i === 0 ? 0.07 : -0.07] : [0.1 * Math.sin(theta) * Math.cos(phi), 0.13 * Math.sin(theta) * Math.sin(phi), 0.07 * Math.cos(theta)];
          return ring.map((c, k) => scale * c + (k === 0 ? along : 0));
        };
        const triangles = [];
        for (let i = 0; i < n; i += 1) {
          for (let j = 0; j < n; j += 1) {
            if (i > 0) triangles.push([at(i, j), at(i + 1, j), at(i, j + 1)]);
            if (i < n - 1) triangles.push([at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)]);
          }
        }
        return triangles;
      };
      const shifted = (triangles, by) => triangles.map((corners) => corners.map((corner) => corner.map((c) => c + by * random())));
      const turned = ([a, b, c]) => [a, c, b];
      const meshes = {
        sound: () => ellipsoid(316),
        hole: () => ellipsoid(316).filter((_, k) => k < 80000 || k >= 80040),
        flipped: () => ellipsoid(316).map((corners, k) => (k % 5000 < 50 ? turned(corners) : corners)),
        "inside-out": () => ellipsoid(316).map(turned),
        nested: () => [...ellipsoid(224), ...ellipsoid(224, 0.5)],
        crossing: () => [...ellipsoid(224), ...ellipsoid(224, 1, 0.1)],
        twice: () => [...ellipsoid(224), ...ellipsoid(224)],
        cracked: () => shifted(ellipsoid(316), 1e-6),
        soup: () => Array.from({ length: 200000 }, () => [1, 2, 3].map(() => [0.01 * random(), 0.01 * random(), 0.01 * random()])).map((corners) => {
          const place = [random(), random(), random()];
          return corners.map((corner) => corner.map((c, k) => c + place[k]));
        }),
      };
      const triangles = meshes[kind]();
      const bytes = new DataView(new ArrayBuffer(84 + 50 * triangles.length));
      bytes.setUint32(80, triangles.length, true);
      triangles.flat(2).forEach((c, k) => bytes.setFloat32(84 + 50 * Math.floor(k / 9) + 12 + 4 * (k % 9), c, true));
      const [session, inspection, { view }] = [window.polhodeLive, window.polhodeInspection, window.polhode];
      const measured = [];
      for (let round = 0; round < rounds; round += 1) {
        const name = `${kind}${round}.stl`;
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([bytes.buffer], name));
        performance.clearResourceTimings();
        const begun = performance.now();
        document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
        const [isInspected, isMoving] = [() => inspection.document?.name === name, () => session.isSettled && session.text.includes(name)];
        while (!isInspected() && !isMoving()) await new Promise((done) => setTimeout(done, 1));
        if (isMoving()) view.render();
        // The frame that was asked for is drawn before this is called.
        else await new Promise((done) => requestAnimationFrame(done));
        const took = performance.now() - begun;
        const parts = { took, drop: 0, open: 0, then: 0 };
        for (const { name: path, duration } of performance.getEntriesByType("resource")) {
          if (/\/documents$/.test(path)) continue;
          const [part] = /drop(?=\?)|open$/.exec(path) ?? ["then"];
          parts[part] += duration;
        }
        measured.push({ ...parts, page: took - parts.drop - parts.open - parts.then });
        await new Promise((done) => setTimeout(done, 400));
      }
      return { rounds: measured, count: triangles.length };
    },
    { kind, rounds: ROUNDS },
  );
  const column = (part) => rounds.map((round) => round[part]).sort((a, b) => a - b);
  const [least, most] = [column("took")[0], column("took")[ROUNDS - 1]];
  const median = (part) => column(part)[Math.floor(ROUNDS / 2)].toFixed(0);
  const parts = ["drop", "open", "then", "page"].map((part) => `${part} ${median(part)}`).join(", ");
  console.log(`${kind}, ${count} triangles, ms: ${median("took")} (${least.toFixed(0)} … ${most.toFixed(0)}): ${parts}`);
}
await page.close();
server.close();

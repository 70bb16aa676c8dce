// How long a mesh of 200,000 triangles takes from the drop until it is shown, with `polhode live` itself: ms to the end of the calls that draw it,
// of a sound one (which moves) and of three that bound no solid. POLHODE names the program (build it with --release). The calls of the GPU are made
// and draw nothing, as without one the pixels are computed in software. Not a test.
import { bare } from "./bare.mjs";
import { serve, example } from "./live-server.mjs";

const ROUNDS = 7;
const server = await serve(example("t-handle.toml"));
const page = await bare(() => {
  for (const call of ["drawElements", "drawArrays", "drawElementsInstanced", "drawArraysInstanced"]) WebGL2RenderingContext.prototype[call] = () => undefined;
});
await page.goto(server.address, () => window.polhodeLive?.isSettled);
for (const kind of ["sound", "twice", "cracked", "soup"]) {
  const { took, count } = await page.evaluate(
    async ({ kind, rounds }) => {
      let seed = 1;
      const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647 - 0.5;
      /** An ellipsoid of n parts from pole to pole, and as many around. */
      const ellipsoid = (n) => {
        const at = (i, j) => {
          const [theta, phi] = [(Math.PI * i) / n, (2 * Math.PI * (j % n)) / n];
          return i === 0 || i === n ? [0, 0, i === 0 ? 0.07 : -0.07] : [0.1 * Math.sin(theta) * Math.cos(phi), 0.13 * Math.sin(theta) * Math.sin(phi), 0.07 * Math.cos(theta)];
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
      const meshes = {
        sound: () => ellipsoid(316),
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
      const took = [];
      for (let round = 0; round < rounds; round += 1) {
        const name = `${kind}${round}.stl`;
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([bytes.buffer], name));
        const begun = performance.now();
        document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
        const isShown = () => (kind === "sound" ? session.isSettled && session.text.includes(name) : inspection.document?.name === name);
        while (!isShown()) await new Promise((done) => setTimeout(done, 1));
        if (kind === "sound") view.render();
        took.push(performance.now() - begun);
        await new Promise((done) => setTimeout(done, 400));
      }
      return { took: took.sort((a, b) => a - b), count: triangles.length };
    },
    { kind, rounds: ROUNDS },
  );
  console.log(`${kind}, ${count} triangles, ms: ${took[Math.floor(ROUNDS / 2)].toFixed(0)} (${took[0].toFixed(0)} … ${took[ROUNDS - 1].toFixed(0)})`);
}
await page.close();
server.close();

/**
 * Normals of a mesh: smooth where its faces nearly agree, sharp at edges. Each corner has the mean normal of the faces around its
 * vertex that are within the crease angle of its own, weighted by their areas.
 */
import { BufferAttribute, BufferGeometry } from "three";

const CREASE = Math.cos((35 * Math.PI) / 180);

export function creased(vertices: Float32Array, triangles: Uint32Array): BufferGeometry {
  const faces = faceNormals(vertices, triangles);
  const { first, around } = facesAround(vertices.length / 3, triangles);
  const positions = new Float32Array(3 * triangles.length);
  const normals = new Float32Array(3 * triangles.length);
  for (let corner = 0; corner < triangles.length; corner += 1) {
    const face = 3 * Math.floor(corner / 3);
    const own = Math.hypot(faces[face], faces[face + 1], faces[face + 2]);
    const vertex = triangles[corner];
    let [x, y, z] = [0, 0, 0];
    for (let k = first[vertex]; k < first[vertex + 1]; k += 1) {
      const other = 3 * around[k];
      const [a, b, c] = [faces[other], faces[other + 1], faces[other + 2]];
      const dot = a * faces[face] + b * faces[face + 1] + c * faces[face + 2];
      if (dot >= CREASE * own * Math.hypot(a, b, c)) {
        x += a;
        y += b;
        z += c;
      }
    }
    const norm = Math.hypot(x, y, z) || 1;
    normals.set([x / norm, y / norm, z / norm], 3 * corner);
    positions.set(vertices.subarray(3 * vertex, 3 * vertex + 3), 3 * corner);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  return geometry;
}

// (b − a) × (c − a): twice the area long.
function faceNormals(v: Float32Array, triangles: Uint32Array): Float32Array {
  const normals = new Float32Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    const [ux, uy, uz] = [v[b] - v[a], v[b + 1] - v[a + 1], v[b + 2] - v[a + 2]];
    const [wx, wy, wz] = [v[c] - v[a], v[c + 1] - v[a + 1], v[c + 2] - v[a + 2]];
    normals[t] = uy * wz - uz * wy;
    normals[t + 1] = uz * wx - ux * wz;
    normals[t + 2] = ux * wy - uy * wx;
  }
  return normals;
}

// The faces of vertex i are around[first[i]] … around[first[i + 1] − 1].
function facesAround(count: number, triangles: Uint32Array): { first: Uint32Array; around: Uint32Array } {
  const first = new Uint32Array(count + 1);
  for (const vertex of triangles) first[vertex + 1] += 1;
  for (let i = 0; i < count; i += 1) first[i + 1] += first[i];
  const next = first.slice();
  const around = new Uint32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner += 1) {
    around[next[triangles[corner]]++] = Math.floor(corner / 3);
  }
  return { first, around };
}

/**
 * Normals of a mesh: smooth where its faces nearly agree, sharp at edges. Each corner has the mean
 * normal of those faces around its vertex that are within the crease angle of its own, weighted by
 * area.
 */
import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from "three";

const ANGLE = (35 * Math.PI) / 180;
const CREASE = Math.cos(ANGLE);
/**
 * Angle limit: if all faces around a vertex are this close to their mean, each is within the crease
 * angle of every other.
 */
const SMOOTH = Math.cos(0.499 * ANGLE);

// Plain loops over numbers, because arrays and calls for each corner would take most of the time
// for a large mesh.
export function creased(vertices: Float32Array, triangles: Uint32Array): BufferGeometry {
  const { faces, sizes } = faceNormals(vertices, triangles);
  const { first, around } = cornersAround(vertices.length / 3, triangles);
  // Vertices whose corners differ are duplicated.
  const index = around.length > 0 ? triangles.slice() : triangles;
  const positions = around.length > 0 ? new Float32Array(vertices.length + 3 * around.length) : vertices;
  const normals = new Float32Array(positions.length);
  if (around.length > 0) positions.set(vertices);
  let count = vertices.length / 3;
  // A vertex of a single face has its normal.
  for (let t = 0, face = 0; t < triangles.length; t += 3, face += 1) {
    const size = sizes[face] || 1;
    const x = faces[t] / size;
    const y = faces[t + 1] / size;
    const z = faces[t + 2] / size;
    for (let corner = t; corner < t + 3; corner += 1) {
      const vertex = triangles[corner];
      if (first[vertex] !== first[vertex + 1]) continue;
      normals[3 * vertex] = x;
      normals[3 * vertex + 1] = y;
      normals[3 * vertex + 2] = z;
    }
  }
  const sum = new Float64Array(3);
  /**
   * Adds the faces at around[from] … around[to − 1] whose component along (u, v, w), relative to
   * their size, is at least `least`. Returns true if all qualify.
   */
  const add = (from: number, to: number, u: number, v: number, w: number, least: number): boolean => {
    let isAll = true;
    let x = 0;
    let y = 0;
    let z = 0;
    for (let k = from; k < to; k += 1) {
      const other = Math.floor(around[k] / 3);
      const a = faces[3 * other];
      const b = faces[3 * other + 1];
      const c = faces[3 * other + 2];
      if (a * u + b * v + c * w < least * sizes[other]) isAll = false;
      else {
        x += a;
        y += b;
        z += c;
      }
    }
    sum[0] = x;
    sum[1] = y;
    sum[2] = z;
    return isAll;
  };
  const put = (at: number): void => {
    const norm = Math.sqrt(sum[0] ** 2 + sum[1] ** 2 + sum[2] ** 2) || 1;
    for (let c = 0; c < 3; c += 1) normals[3 * at + c] = sum[c] / norm;
  };
  for (let vertex = 0; vertex + 1 < first.length; vertex += 1) {
    const from = first[vertex];
    const to = first[vertex + 1];
    if (from === to) continue;
    add(from, to, 0, 0, 0, 0);
    const mean = Math.sqrt(sum[0] ** 2 + sum[1] ** 2 + sum[2] ** 2);
    if (add(from, to, sum[0], sum[1], sum[2], SMOOTH * mean)) {
      put(vertex);
      continue;
    }
    for (let k = from; k < to; k += 1) {
      const own = Math.floor(around[k] / 3);
      add(from, to, faces[3 * own], faces[3 * own + 1], faces[3 * own + 2], CREASE * sizes[own]);
      if (k === from) {
        put(vertex);
        continue;
      }
      for (let c = 0; c < 3; c += 1) positions[3 * count + c] = vertices[3 * vertex + c];
      index[around[k]] = count;
      put(count);
      count += 1;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(index, 1));
  geometry.setAttribute("position", new BufferAttribute(positions.subarray(0, 3 * count), 3));
  geometry.setAttribute("normal", new BufferAttribute(normals.subarray(0, 3 * count), 3));
  geometry.boundingSphere = sphereAround(vertices);
  return geometry;
}

// Returns (b − a) × (c − a), whose length is twice the area, and that length.
function faceNormals(v: Float32Array, triangles: Uint32Array): { faces: Float32Array; sizes: Float64Array } {
  const faces = new Float32Array(triangles.length);
  const sizes = new Float64Array(triangles.length / 3);
  for (let t = 0, face = 0; t < triangles.length; t += 3, face += 1) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const ux = v[b] - v[a];
    const uy = v[b + 1] - v[a + 1];
    const uz = v[b + 2] - v[a + 2];
    const wx = v[c] - v[a];
    const wy = v[c + 1] - v[a + 1];
    const wz = v[c + 2] - v[a + 2];
    faces[t] = uy * wz - uz * wy;
    faces[t + 1] = uz * wx - ux * wz;
    faces[t + 2] = ux * wy - uy * wx;
    sizes[face] = Math.sqrt(faces[t] ** 2 + faces[t + 1] ** 2 + faces[t + 2] ** 2);
  }
  return { faces, sizes };
}

// The corners at vertex i, if there are several, are around[first[i]] … around[first[i + 1] − 1].
function cornersAround(count: number, triangles: Uint32Array): { first: Uint32Array; around: Uint32Array } {
  const uses = new Uint32Array(count);
  for (let corner = 0; corner < triangles.length; corner += 1) uses[triangles[corner]] += 1;
  const first = new Uint32Array(count + 1);
  let several = 0;
  for (let i = 0; i < count; i += 1) first[i + 1] = several += uses[i] > 1 ? uses[i] : 0;
  const around = new Uint32Array(several);
  // In reverse order: the remaining count of its uses is the place of a corner at its vertex.
  for (let corner = triangles.length - 1; several > 0 && corner >= 0; corner -= 1) {
    const vertex = triangles[corner];
    if (first[vertex] !== first[vertex + 1]) around[first[vertex] + (uses[vertex] -= 1)] = corner;
  }
  return { first, around };
}

// Returns the sphere around the bounding box.
function sphereAround(points: Float32Array): Sphere {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < points.length; k += 3) {
    for (let c = 0; c < 3; c += 1) {
      const x = points[k + c];
      if (x < low[c]) low[c] = x;
      if (x > high[c]) high[c] = x;
    }
  }
  const [from, to] = [new Vector3(...low), new Vector3(...high)];
  return points.length > 0 ? new Sphere(from.clone().add(to).divideScalar(2), from.distanceTo(to) / 2) : new Sphere();
}

/**
 * Normals of a mesh: smooth where its faces nearly agree, sharp at edges. Each corner has the mean normal of the faces around its
 * vertex that are within the crease angle of its own, weighted by their areas.
 */
import { Box3, BufferAttribute, BufferGeometry, Sphere, Vector3 } from "three";

const ANGLE = (35 * Math.PI) / 180;
const CREASE = Math.cos(ANGLE);
/** If all faces around a vertex are so near to their mean, each is within the crease angle of every other. */
const SMOOTH = Math.cos(0.499 * ANGLE);

// Plain loops over numbers: arrays and calls for each corner would take most of the time in which a large mesh is shown.
export function creased(vertices: Float32Array, triangles: Uint32Array): BufferGeometry {
  const { faces, sizes } = faceNormals(vertices, triangles);
  const { first, around } = cornersAround(vertices.length / 3, triangles);
  const positions = new Float32Array(3 * triangles.length);
  const normals = new Float32Array(3 * triangles.length);
  // Of the faces of around[from] … around[to − 1] within an angle of (u, v, w), which is so long.
  const sum = new Float64Array(3);
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
  for (let vertex = 0; vertex + 1 < first.length; vertex += 1) {
    const from = first[vertex];
    const to = first[vertex + 1];
    add(from, to, 0, 0, 0, 0);
    const mean = Math.sqrt(sum[0] ** 2 + sum[1] ** 2 + sum[2] ** 2);
    const isSmooth = add(from, to, sum[0], sum[1], sum[2], SMOOTH * mean);
    for (let k = from; k < to; k += 1) {
      const corner = around[k];
      if (!isSmooth) {
        const own = Math.floor(corner / 3);
        add(from, to, faces[3 * own], faces[3 * own + 1], faces[3 * own + 2], CREASE * sizes[own]);
      }
      const norm = Math.sqrt(sum[0] ** 2 + sum[1] ** 2 + sum[2] ** 2) || 1;
      for (let c = 0; c < 3; c += 1) {
        normals[3 * corner + c] = sum[c] / norm;
        positions[3 * corner + c] = vertices[3 * vertex + c];
      }
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  // Of each vertex once, not of each corner.
  geometry.boundingSphere = sphereAround(vertices);
  return geometry;
}

// (b − a) × (c − a), twice the area long; and how long that is.
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

// The corners at vertex i are around[first[i]] … around[first[i + 1] − 1].
function cornersAround(count: number, triangles: Uint32Array): { first: Uint32Array; around: Uint32Array } {
  const first = new Uint32Array(count + 1);
  for (let corner = 0; corner < triangles.length; corner += 1) first[triangles[corner] + 1] += 1;
  for (let i = 0; i < count; i += 1) first[i + 1] += first[i];
  const next = first.slice();
  const around = new Uint32Array(triangles.length);
  for (let corner = 0; corner < triangles.length; corner += 1) around[next[triangles[corner]]++] = corner;
  return { first, around };
}

// About the middle of the box around them.
function sphereAround(points: Float32Array): Sphere {
  const box = new Box3();
  const point = new Vector3();
  for (let k = 0; k < points.length; k += 3) box.expandByPoint(point.fromArray(points, k));
  const sphere = new Sphere();
  if (box.isEmpty()) return sphere;
  box.getCenter(sphere.center);
  let most = 0;
  for (let k = 0; k < points.length; k += 3) most = Math.max(most, sphere.center.distanceToSquared(point.fromArray(points, k)));
  sphere.radius = Math.sqrt(most);
  return sphere;
}

/** Data of the page before there is a motion: a ball at rest, which is not shown. */
import { base64Of } from "../base64";
import type { PageData } from "../data";

const numbers = (...values: number[]): string => base64Of(new Uint8Array(Float64Array.from(values).buffer));

export const EMPTY: PageData = {
  version: 1,
  title: "polhode live",
  source: "polhode live",
  scenario: null,
  body: {
    mass: null,
    inertia: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
    about: "centre of mass",
    lever: [0, 0, 0],
    principal: { moments: [1, 1, 1], quaternion: [1, 0, 0, 0] },
    ellipsoid: { half: [1, 1, 1], quaternion: [1, 0, 0, 0] },
    box: null,
    shapes: [],
  },
  motion: {
    count: 1,
    method: "none",
    times: numbers(0),
    attitude: numbers(1, 0, 0, 0),
    omega: numbers(0, 0, 0),
    momentum: numbers(0, 0, 0),
    torque: null,
    kinetic: numbers(0),
    potential: null,
    work: null,
    drift: [],
    wheels: [],
    pointings: [],
    directions: [],
    events: [],
    eventCount: 0,
    contact: null,
    complete: true,
  },
  free: null,
  scene: { period: null, gravity: null, orbit: null, captions: { body: "", poinsot: null, cones: null, sphere: null } },
  top: null,
  facts: [],
  findings: [],
  explanation: [],
};

/**
 * A body on the ground: position, contact point, contact forces, and the geometry of the ground.
 */
import type { Vector } from "./attitude";
import type { ContactData, GroundData, Row, Shape } from "./data";
import { f64 } from "./decode";

export type Phase = ContactData["phases"][number];

export class Contact {
  readonly ground: GroundData;
  readonly up: Vector | null;
  readonly surface: Shape | null;
  readonly center: Float64Array;
  readonly point: Float64Array;
  readonly normalForce: Float64Array;
  readonly friction: Float64Array;
  readonly slip: Float64Array;
  readonly frictionWork: Float64Array;
  readonly groundWork: Float64Array;
  readonly phases: readonly Phase[];

  constructor(data: ContactData, count: number) {
    const row = (values: Row, what: string, width = 1): Float64Array => f64(values, what, width * count);
    this.ground = data.ground;
    this.up = data.up;
    this.surface = data.surface;
    this.center = row(data.center, "centre of mass", 3);
    this.point = row(data.point, "point of contact", 3);
    this.normalForce = row(data.normalForce, "normal force");
    this.friction = row(data.friction, "friction");
    this.slip = row(data.slip, "slip");
    this.frictionWork = row(data.frictionWork, "work of friction");
    this.groundWork = row(data.groundWork, "work of the ground");
    this.phases = data.phases;
  }

  /**
   * Time until which the body touches the ground, s. A motion ends when the body touches it again.
   */
  get touchesUntil(): number {
    return this.phases.find(({ name }) => name === "flying")?.from ?? Infinity;
  }
}

/** Returns the normal of the ground at one of its points, towards the body. */
export function normalAt({ form, inside, axis }: GroundData, point: Vector): Vector {
  if (form === "plane") return axis;
  const along = form === "cylinder" ? point[0] * axis[0] + point[1] * axis[1] + point[2] * axis[2] : 0;
  const out = point.map((x, k) => x - along * axis[k]);
  const size = (inside ? -1 : 1) * (Math.hypot(...out) || 1);
  return [out[0] / size, out[1] / size, out[2] / size];
}

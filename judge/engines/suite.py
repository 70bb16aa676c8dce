"""Cases of `polhode judge --write-suite DIR`, and runs for `polhode judge --suite DIR`.

Components are in body axes if a name ends in `_body`, and in space axes if it ends in `_space`.
Quaternions are (w, x, y, z) and take body components to space components.
"""

import argparse
import json
import math
import time
from pathlib import Path

import numpy as np

COLUMNS = "time_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s"

NO_NUMBER = "the engine's state is not finite"


class NotRun(Exception):
    """Reason why an engine cannot compute a case."""


def matrix(q):
    """Returns R_space_body of a quaternion."""
    w, x, y, z = q
    return np.array([
        [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
    ])


def quaternion(r):
    """Returns the quaternion (w, x, y, z) of a rotation matrix."""
    q = np.array([
        [r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
        [0, r[0, 0] - r[1, 1] - r[2, 2], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
        [0, 0, r[1, 1] - r[0, 0] - r[2, 2], r[1, 2] + r[2, 1]],
        [0, 0, 0, r[2, 2] - r[0, 0] - r[1, 1]],
    ])
    values, vectors = np.linalg.eigh(q, UPLO="U")
    return vectors[:, np.argmax(values)]


class Case:
    """A case: body, start and torques as numbers, SI units."""

    def __init__(self, entry):
        self.name = entry["name"]
        self.mass = float(entry["mass_kg"])
        self.inertia = np.array(entry["inertia_kg_m2"], float)  # about the centre of mass
        self.center_of_mass = np.array(entry.get("center_of_mass_m", [0, 0, 0]), float)  # from the pivot
        self.attitude = np.array(entry["attitude"], float)
        self.omega_body = np.array(entry["omega_body_rad_s"], float)
        self.duration = float(entry["duration_s"])
        self.rows_every = float(entry["rows_every_s"])
        self.gravity = None  # space axes; the body is then held at its pivot
        self.torques = []  # functions (t, R_space_body, omega_body) -> torque in body axes
        for torque in entry["torque"]:
            self._add(torque)

    def _add(self, torque):
        kind = torque["kind"]
        if kind == "gravity":
            self.gravity = np.array(torque["acceleration_m_s2"], float)
        elif kind == "constant-body":
            n = np.array(torque["torque_n_m"], float)
            self.torques.append(lambda t, r, w: n)
        elif kind == "constant-space":
            n = np.array(torque["torque_n_m"], float)
            self.torques.append(lambda t, r, w: r.T @ n)
        elif kind == "damping":
            c = np.array(torque["coefficient_n_m_s"], float)
            self.torques.append(lambda t, r, w: -c * w)
        elif kind == "formula":
            code = [compile(f.replace("^", "**"), self.name, "eval") for f in torque["torque_n_m"]]
            names = {"sin": math.sin, "cos": math.cos}
            value = lambda t: np.array([eval(c, names, {"t": t}) for c in code])
            body = torque["axes"] == "body"
            self.torques.append(lambda t, r, w: value(t) if body else r.T @ value(t))
        elif kind == "gravity-gradient":
            k = 3 * torque["mu_m3_s2"] / torque["radius_m"] ** 3
            n, x, y = torque["rate_rad_s"], np.array(torque["radial"], float), np.array(torque["motion"], float)
            i = self.inertia

            def gradient(t, r, w):
                u = r.T @ (math.cos(n * t) * x + math.sin(n * t) * y)
                return k * np.cross(u, i @ u)

            self.torques.append(gradient)
        elif kind == "wheel":
            self._add_wheel(torque)
        else:
            raise SystemExit(f"{self.name}: a torque of kind {kind} is not known here")

    def _add_wheel(self, wheel):
        """Adds a wheel as its torque on the body: -w x h, and the reaction of its motor.

        With a motor, h is the wheel's own momentum along its axis, and the inertia of the body
        excludes the wheel's moment about that axis.
        """
        a, j = np.array(wheel["axis"], float), wheel["moment_kg_m2"]
        motor = wheel.get("motor_torque_n_m")
        if motor is None:
            h = j * wheel["speed_rad_s"] * a
            self.torques.append(lambda t, r, w: -np.cross(w, h))
        else:
            start = j * (wheel["speed_rad_s"] + a @ self.omega_body)
            self.inertia = self.inertia - j * np.outer(a, a)
            self.torques.append(lambda t, r, w: -motor * a - np.cross(w, (start + motor * t) * a))

    def torque_body(self, t, r, omega_body):
        """Returns the torque in body axes, without gravity on a held body, N·m."""
        return sum(n(t, r, omega_body) for n in self.torques)

    def principal(self):
        """Returns principal moments, ascending, and right-handed principal axes as columns."""
        moments, axes = np.linalg.eigh(self.inertia)
        if np.linalg.det(axes) < 0:
            axes[:, 2] = -axes[:, 2]
        return moments, axes

    def steps(self, step):
        """Returns the number of steps of the case, and the number of steps between rows."""
        return round(self.duration / step), max(1, round(self.rows_every / step))


def write(path, engine, step, rows):
    """Writes a run as CSV.

    Each row is a time, a quaternion and an angular velocity in body axes.
    """
    with open(path, "w") as file:
        file.write(f'# engine = "{engine}"\n')
        if step is not None:
            file.write(f"# step = {step!r}\n")
        file.write(COLUMNS + "\n")
        for t, q, w in rows:
            file.write(",".join(repr(float(v)) for v in (t, *q, *w)) + "\n")


def collect(rows, run):
    """Collects the rows of a run. Returns the reason if they end early, else None."""
    try:
        for t, q, w in run:
            if not np.isfinite([*q, *w]).all():
                return NO_NUMBER
            rows.append((t, q, w))
    except np.linalg.LinAlgError:
        return NO_NUMBER
    except (NotRun, RuntimeError) as why:
        return str(why).splitlines()[0]
    return None


def main(settings, run):
    """Runs the cases.

    `settings` has (text of the engine, its own step) by name; `run(case, setting, step)` yields
    rows. A step of None means that the engine chooses its steps for its accuracy.
    """
    parser = argparse.ArgumentParser()
    parser.add_argument("suite", type=Path, help="the folder with suite.json")
    parser.add_argument("--out", type=Path, help="where the runs go; the suite's folder if not given")
    parser.add_argument("--setting", choices=settings, default="default")
    parser.add_argument("--step", type=float, action="append", help="steps in s, instead of the setting's own")
    parser.add_argument("--case", action="append", help="only these")
    args = parser.parse_args()
    out = args.out or args.suite
    out.mkdir(parents=True, exist_ok=True)
    engine, own_step = settings[args.setting]
    not_run = []
    for entry in json.loads((args.suite / "suite.json").read_text())["cases"]:
        if args.case and entry["name"] not in args.case:
            continue
        for step in args.step or [own_step]:
            name = entry["name"] + (f"@{step!r}" if args.step else "")
            start = time.perf_counter()
            rows = []
            why = collect(rows, run(Case(entry), args.setting, step))
            if why:
                last = f"ends after {rows[-1][0]!r} s" if rows else "not run"
                print(f"{name}: {last}: {why}")
                not_run.append(f"{entry['name']}: {why if last == 'not run' else f'{last}: {why}'}\n")
            if len(rows) > 1:
                write(out / f"{name}.csv", engine, step, rows)
                print(f"{name}: {len(rows)} rows, {time.perf_counter() - start:.2f} s")
    (out / "not-run.txt").write_text("".join(not_run))

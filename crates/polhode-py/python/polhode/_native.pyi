"""Interface of the Rust extension. It is private: the public functions check arguments before they
call it."""

from pathlib import Path
from typing import Any, Callable, Sequence, TypedDict

import numpy as np
import numpy.typing as npt

from ._arrays import Floats
from ._substance import Given

VERSION: str

def run_command(arguments: Sequence[str]) -> int: ...

#: Name, unit, description and values of a column, and a mask of the rows with values if some have
#: none.
Column = tuple[str, str, str, Any, npt.NDArray[np.bool_] | None]

#: Code, severity, message and place of a finding.
Remark = tuple[str, str, str, str | None]

#: Pickled state of mass properties. Its structure is private to Rust.
MassState = tuple[Any, Any, Any, Any, Any]

#: Mass, centre of mass, and tensor about the centre of mass.
MassNumbers = tuple[float, list[float], list[list[float]]]

class MeshOptions(TypedDict):
    unit: float | None
    hull: bool
    shell: float | None
    weld: str | None
    fill: str | None
    close_within: str | None
    print: tuple[list[float], str] | None
    union: bool
    check: bool
    parts: list[tuple[str, Given]]
    field: str | None
    tolerance: float | None

class Solid(TypedDict):
    name: str
    volume: float
    area: float
    center: list[float]
    tensor: list[list[float]]

class Step(TypedDict):
    left_out: int
    invalid: list[int]
    error: float

class Compared(TypedDict):
    path: str
    text: str | None
    moments: list[float] | None
    start_omega: list[float] | None

class Said(TypedDict):
    quaternion: str | None
    sense: str | None
    omega_axes: str | None
    axes: str | None
    time_origin: float | None
    step: float | None
    engine: str | None

class Explained(TypedDict):
    json: str
    text: str
    markdown: str
    html: str
    latex: str

class RequiredTorque(TypedDict):
    json: str
    text: str
    columns: list[tuple[str, str, str, Floats]]
    findings: list[Remark]

class Judged(TypedDict):
    times: Floats
    attitude: Floats
    omega: Floats | None
    exact_attitude: Floats
    exact_omega: Floats
    attitude_error: Floats
    attitude_error_vector: Floats
    omega_error: Floats | None
    kinetic_energy_error: Floats | None
    momentum_error: Floats | None
    momentum_direction_error: Floats | None
    is_exact: bool
    findings: list[Remark]
    json: str
    text: str
    markdown: str
    page: str

class DerivedEvent(TypedDict):
    name: str
    time: float
    omega: Floats
    attitude: Floats
    by_start: Floats
    by_inertia: Floats
    by_parameters: Floats
    time_by_start: Floats
    time_by_inertia: Floats
    time_by_parameters: Floats

class Derived(TypedDict):
    times: Floats
    omega: Floats
    attitude: Floats
    by_start: Floats
    by_inertia: Floats
    by_parameters: Floats
    inertia_by_mass_properties: Floats
    parameters: list[str]
    events: list[DerivedEvent]

class ByParticles(TypedDict):
    by_masses: Floats
    by_positions: Floats

class ByParts(TypedDict):
    by_masses: Floats
    by_positions: Floats
    by_rotations: Floats
    by_parts: Floats

class FlightArrays(TypedDict):
    name: str
    times: Floats
    gyro: Floats
    attitude_times: Floats
    attitude: Floats
    added: list[float] | None
    wheels: list[tuple[list[float], float]]
    torques: str

class FlightOptions(TypedDict):
    bias: bool
    scale: bool
    skew: bool
    clock: bool
    drag: str
    gyro_noise: float | None
    attitude_noise: float | None
    outlier: float

class WrenchArrays(TypedDict):
    times: Floats
    omega: Floats
    alpha: Floats
    acceleration: Floats
    gravity: Floats
    attitude: Floats | None
    force: Floats
    torque: Floats

class WrenchOptions(TypedDict):
    on_sensor: bool
    bias: bool
    noise: list[float] | None
    covariance: list[list[float]] | None
    motion_noise: list[float]
    kind: str | None

class Identified(TypedDict):
    json: str
    text: str
    markdown: str
    page: str
    has_model_error: bool
    body: MassNumbers | None
    wrench: Floats | None
    swings: list[Floats]
    times: Floats | None

class BudgetAsked(TypedDict):
    is_basic: bool | None
    about: list[float] | None
    axes: list[list[float]] | None
    draws: int | None
    seed: int | None
    configuration: str | None

class Budgeted(TypedDict):
    json: str
    text: str
    markdown: str
    page: str
    is_beyond: bool
    draws: list[Floats]
    scenarios: list[str]

class MassProperties:
    @staticmethod
    def of_tensor(
        mass: float, center: list[float], tensor: list[list[float]], about: list[float] | None
    ) -> MassProperties: ...
    @staticmethod
    def of_particles(masses: Floats, positions: Floats) -> MassProperties: ...
    @staticmethod
    def combined(parts: list[MassProperties]) -> MassProperties: ...
    def placed(self, position: list[float], wxyz: list[float]) -> MassProperties: ...
    @property
    def mass(self) -> float: ...
    @property
    def center_of_mass(self) -> Floats: ...
    @property
    def inertia(self) -> Floats: ...
    def about(self, point: list[float]) -> Floats: ...
    def along(self, wxyz: list[float]) -> Floats: ...
    @property
    def moments(self) -> Floats: ...
    @property
    def axes(self) -> Floats: ...
    @property
    def symmetry(self) -> str: ...
    @property
    def gyration_radii(self) -> Floats: ...
    @property
    def volume(self) -> float | None: ...
    @property
    def surface_area(self) -> float | None: ...
    @property
    def density(self) -> float | None: ...
    @property
    def findings(self) -> list[Remark]: ...
    def state(self) -> MassState: ...
    @staticmethod
    def of_state(state: MassState) -> MassProperties: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def export(self, format: str, name: str) -> str: ...

class MeshDerivatives:
    @staticmethod
    def of(vertices: Floats, triangles: npt.NDArray[np.uint32], given: Given) -> MeshDerivatives: ...
    @property
    def mass_properties(self) -> MassProperties: ...
    @property
    def by_mass(self) -> Floats: ...
    @property
    def by_density(self) -> Floats: ...
    def gradient(self, of_numbers: Floats) -> Floats: ...

class FreeMotion:
    @staticmethod
    def of_moments(moments: list[float], omega: list[float], wxyz: Sequence[float], unphysical: bool) -> FreeMotion: ...
    @staticmethod
    def of_tensor(tensor: list[list[float]], omega: list[float], wxyz: Sequence[float]) -> FreeMotion: ...
    def at_time(self, time: float) -> tuple[Floats, Floats]: ...
    def few(self, times: Floats) -> tuple[Floats, Floats, Floats]: ...
    def fill(self, times: Floats, omega: Floats, attitude: Floats) -> None: ...
    def derivatives(self, times: Floats) -> Derived: ...
    def error(self, times: Floats) -> list[list[Floats]]: ...
    @property
    def regime(self) -> str: ...
    @property
    def regime_in_words(self) -> str: ...
    @property
    def period(self) -> float | None: ...
    @property
    def flip_interval(self) -> float | None: ...
    @property
    def kinetic_energy(self) -> float: ...
    @property
    def momentum(self) -> Floats: ...
    @property
    def moments(self) -> Floats: ...
    @property
    def axes(self) -> Floats: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    def page(self, duration: float) -> str: ...

class Motion:
    def derivatives(self) -> Derived | None: ...
    def columns(self) -> list[tuple[str, str, str, Floats]]: ...
    def at(self, times: Floats) -> tuple[Floats, Floats]: ...
    def after(self, times: Floats, error: str) -> Motion: ...
    @property
    def source(self) -> tuple[Path, str]: ...
    @property
    def events(self) -> list[tuple[str, float, bool, list[float], list[float]]]: ...
    @property
    def error(self) -> list[list[Floats]] | None: ...
    @property
    def ending(self) -> tuple[str, str | None, float | None]: ...
    @property
    def findings(self) -> list[Remark]: ...
    @property
    def title(self) -> str | None: ...
    def json(self) -> str: ...
    def text(self) -> str: ...
    @property
    def has_triangles(self) -> bool: ...
    def page_data(self, triangles: int | None) -> str: ...

#: Python function of the state of one body: the function, the parts of the state in the order of its
#: arguments, and the conversion of its result, which also takes the time.
StateFunction = tuple[Callable[..., Any], list[str], Callable[[Any, float], Any]]

#: Torques and events that Python functions compute: index in the list, and index of the function.
Placed = tuple[list[tuple[int, int]], list[tuple[int, int]]]

class Ensemble:
    @staticmethod
    def of(
        bodies: tuple[tuple[Floats, Floats] | None, Floats],
        pivots: Floats | None,
        omega: Floats,
        attitude: Floats,
        actions: tuple[list[tuple[str, str, str, Placed]], list[int] | None],
        functions: tuple[list[tuple[bool, StateFunction | Callable[..., Any]]], list[tuple[bool, StateFunction]]],
    ) -> Ensemble: ...
    @staticmethod
    def of_scenarios(
        scenarios: list[tuple[str, str, Placed]],
        functions: tuple[list[tuple[bool, StateFunction | Callable[..., Any]]], list[tuple[bool, StateFunction]]],
    ) -> Ensemble: ...
    @property
    def findings(self) -> list[Remark]: ...
    def __len__(self) -> int: ...
    def at(
        self, times: Floats, threads: int | None, tolerance: float, method: str
    ) -> tuple[
        Floats,
        list[tuple[int, float, str]],
        list[tuple[int, str, float]],
        list[tuple[int, str, float, bool, list[float], list[float]]],
    ]: ...

class Plan:
    @staticmethod
    def read(path: str) -> Plan: ...
    @staticmethod
    def parse(text: str, path: str) -> Plan: ...
    @property
    def text(self) -> str: ...
    @property
    def path(self) -> str: ...
    @property
    def members(self) -> int: ...
    @property
    def digest(self) -> str: ...
    @property
    def wants_trajectories(self) -> bool: ...
    @property
    def variables(self) -> list[tuple[str, str, str]]: ...
    @property
    def findings(self) -> list[Remark]: ...
    def inputs(self, start: int, stop: int) -> list[Column]: ...
    def simulate(self, inputs: list[tuple[str, Any]]) -> list[Column]: ...
    def trajectories(self, inputs: list[tuple[str, Any]]) -> list[Column]: ...

class Dataset:
    @staticmethod
    def open(folder: str, plan: Plan, mode: str) -> Dataset: ...
    @property
    def parts(self) -> int: ...
    def rows(self, part: int) -> tuple[int, int]: ...
    def missing(self) -> list[int]: ...
    def write(self, part: int, columns: list[Column]) -> None: ...
    def write_trajectories(self, part: int, columns: list[Column]) -> None: ...
    def compute(self, plan: Plan, threads: int, progress: Callable[[int, int], object]) -> None: ...
    def finish(self, plan: Plan, threads: int) -> tuple[str, str]: ...

def free_motions(
    inertia: Floats, attitude: Floats, omega: Floats, times: Floats, with_derivatives: bool
) -> tuple[Floats, list[Floats]] | None: ...

class ReadScenario:
    @staticmethod
    def of_text(path: str, text: str) -> ReadScenario: ...
    @property
    def findings(self) -> list[Remark]: ...

def simulate(
    source: ReadScenario | tuple[str, str | None],
    times: Floats | None,
    error: str,
    derivatives: list[str] | None,
    own: tuple[list[tuple[int, bool, StateFunction]], list[tuple[int, bool, StateFunction]]],
) -> Motion: ...
def scenario_tables(path: str, text: str | None) -> str: ...
def scenario_knobs(path: str, text: str) -> str: ...
def particle_derivatives(masses: Floats, positions: Floats) -> ByParticles: ...
def body_derivatives(parts: list[MassProperties], about: list[list[float]]) -> ByParts: ...
def carried_covariance(by_start: Floats, by_inertia: Floats, by_parameters: Floats, joint: Floats) -> Floats: ...
def identify_plan(path: str, text: str | None, is_written: bool) -> Identified: ...
def identify_flights(title: str | None, flights: list[FlightArrays], options: FlightOptions) -> Identified: ...
def identify_wrenches(title: str | None, given: WrenchArrays, options: WrenchOptions) -> Identified: ...
def budget_list(path: str, text: str | None, head: int | None, asked: BudgetAsked) -> Budgeted: ...
def find_flights(times: Floats, gyro: Floats, slowest: float, shortest: float, torque: float) -> list[list[float]]: ...
def motion_page(title: str | None, data: str) -> str: ...
def judge_arrays(compared: Compared, times: Floats, attitude: Floats, omega: Floats | None, said: Said) -> Judged: ...
def judge_file(compared: Compared, run: str, columns: str | None, said: Said) -> Judged: ...
def quaternion_of_text(name: str, text: str) -> list[float]: ...
def quaternions_of_matrices(name: str, matrices: Floats) -> Floats: ...
def nearest_tensors(
    tensor: list[list[float]],
) -> tuple[tuple[list[list[float]], float], tuple[list[list[float]], float] | None]: ...
def check_file(path: str, roots: list[str], nearest: bool) -> tuple[str, str, str]: ...
def compare_files(a: str, b: str, tolerance: float, map: str | None, roots: list[str]) -> tuple[str, str]: ...
def shape(kind: str, lengths: Sequence[float], ends: bool, given: Given) -> MassProperties: ...
def mesh_file(path: str, format: str, options: MeshOptions, given: Given) -> MassProperties: ...
def step_solids(path: str, solids: list[Solid], said: Step, given: Given) -> MassProperties: ...
def mesh_arrays(
    vertices: Floats, triangles: npt.NDArray[np.uint32], options: MeshOptions, given: Given
) -> MassProperties: ...
def mesh_corners(corners: Floats, options: MeshOptions, given: Given) -> MassProperties: ...
def scenario_file(path: str) -> MassProperties: ...
def particle_file(
    path: str, mass: float | None, length_unit: float | None, mass_unit: float | None
) -> MassProperties: ...
def cad_file(
    path: str, products: str | None, decimal: str | None, length_unit: float | None, mass_unit: float | None
) -> MassProperties: ...
def molecule_file(path: str, average: bool) -> list[MassProperties]: ...
def voxel_file(
    path: str, spacing: list[float] | None, origin: list[float] | None, unit: float | None, per_value: float
) -> MassProperties: ...
def robot_file(
    path: str, link: str | None, subtree: str | None, joints: list[tuple[str, float | str]]
) -> MassProperties: ...
def robot_groups(path: str) -> list[tuple[str, MassProperties]]: ...
def robot_table(path: str, joints: list[tuple[str, float | str]]) -> tuple[str, str, str, list[Remark]]: ...
def robot_links(path: str) -> list[str]: ...
def robot_inertials(request: str) -> tuple[str, str, str, bool]: ...
def is_robot(path: str) -> bool: ...
def available_threads() -> int: ...
def materials() -> list[tuple[str, float]]: ...
def explain_scenario(path: str, text: str | None, formalism: str) -> Explained: ...
def scenario_stability(path: str, text: str | None) -> tuple[str, str]: ...
def required_torque(path: str, text: str | None, times: Floats | None, points: Floats) -> RequiredTorque: ...
def tumbling_spins(tensor: list[list[float]], periods: list[float], is_long: bool) -> tuple[str, str]: ...
def quantity(text: str, powers: tuple[int, int, int, int]) -> float | None: ...
def unit(name: str, of_mass: bool) -> float: ...

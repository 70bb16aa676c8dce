"""The command that the wheel carries, compared with the program: the same bytes, the same status, the same end by a signal.

Signals, shells and closed streams are those of Unix, where these tests are run.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import sysconfig
import time
from pathlib import Path

import pytest

#: The command of the wheel, and the same by the module's name.
COMMAND = [str(Path(sysconfig.get_path("scripts")) / "polhode")]
MODULE = [sys.executable, "-m", "polhode"]

#: A minute of work, or more.
LONG = """
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
spin = { body = [3.1, -1.2, 20.7] }
[[torque]]
model = "formula"
axes = "body"
torque = ["0.01[N m]*sin(t/1[s])", "0.02[N m s]*wx", "-0.01[N m s]*wz"]
[run]
duration = "1 d"
samples = 11
"""

#: Free motion at the times that standard input has.
SPIN = ["spin", "--moments", "1,2,3", "--omega", "0.01,1,0.01", "--at-file", "-", "--json"]


@pytest.fixture
def program() -> list[str]:
    """The program that `cargo build -p polhode-cli` makes."""
    path = os.environ.get("POLHODE")
    assert path, "POLHODE has to say where the program polhode is"
    return [path]


def run(command: list[str], *arguments: str, **options: object) -> tuple[int, bytes, bytes]:
    done = subprocess.run([*command, *arguments], capture_output=True, timeout=100, **options)  # type: ignore[call-overload]
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize(
    ("status", "arguments"),
    [
        (0, ["--version"]),
        (0, ["--help"]),
        (0, ["spin", "--moments", "1,2,3", "--omega", "0.01,1,0.01", "--json"]),
        (0, ["simulate", "t-handle.toml", "-o", "out", "--json"]),
        (0, ["completions", "zsh"]),
        (0, ["man"]),
        (0, ["schema", "scenario"]),
        (1, ["check", "robots/bad-arm.urdf"]),
        (2, []),
        (2, ["spin", "--moments", "1,2,-3", "--omega", "1,2,3"]),
        (2, ["inertia", "part.stl", "--density", "-2 kg/m^3"]),
        (2, ["inertia", "no\udcff.stl"]),
    ],
)
def test_it_answers_as_the_program_does(
    program: list[str], status: int, arguments: list[str], examples: Path, tmp_path: Path
) -> None:
    answers = []
    for command in [program, COMMAND] + ([MODULE] if status or arguments == ["--version"] else []):
        place = tmp_path / str(len(answers))
        place.mkdir()
        for name in ["t-handle.toml", "robots"]:
            (place / name).symlink_to(examples / name)
        answer = run(command, *arguments, cwd=place)
        files = {path.name: path.read_bytes() for path in place.glob("out/*")}
        answers.append((answer, files))
    assert answers[0][0][0] == status
    for answer in answers[1:]:
        assert answer == answers[0]


def test_what_cannot_be_computed_has_status_3(program: list[str], tmp_path: Path) -> None:
    torque = 'model = "constant"\naxes = "body"\ntorque = [1e300, 2e300, -1e300]'
    before, after = LONG.split('model = "formula"')
    (tmp_path / "burst.toml").write_text(before + torque + after[after.index("\n[run]") :])
    [ours, theirs] = [run(command, "simulate", "burst.toml", "--force", cwd=tmp_path) for command in [COMMAND, program]]
    assert (ours, ours[0]) == (theirs, 3)


def test_standard_input_is_read(program: list[str]) -> None:
    [ours, theirs] = [run(command, *SPIN, input=b"0\n1.5\n1e9\n") for command in [COMMAND, program]]
    assert (ours, ours[0]) == (theirs, 0)


def test_a_closed_pipe_is_no_error() -> None:
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run([*COMMAND, "man"], stdout=write, stderr=subprocess.PIPE, timeout=100)
    os.close(write)
    assert (done.returncode, done.stderr) == (0, b"")


def test_a_closed_stream_is_not_the_next_file(program: list[str], examples: Path, tmp_path: Path) -> None:
    for command, name in [(COMMAND, "ours"), (program, "theirs")]:
        arguments = ["simulate", str(examples / "t-handle.toml"), "-o", name, "--table", "csv"]
        shell = ["sh", "-c", 'exec "$0" "$@" <&- >&- 2>&-', *command, *arguments]
        assert subprocess.run(shell, cwd=tmp_path, timeout=100).returncode == 0
    ours, theirs = [{p.name: p.read_bytes() for p in (tmp_path / name).iterdir()} for name in ["ours", "theirs"]]
    assert ours == theirs and len(ours) == 3


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_and_leaves_nothing(number: signal.Signals, tmp_path: Path, ctrl_c: None) -> None:
    (tmp_path / "long.toml").write_text(LONG)
    child = subprocess.Popen([*COMMAND, "simulate", "long.toml", "-o", "out"], cwd=tmp_path, stderr=subprocess.PIPE)
    while not list(tmp_path.glob(f".out.partial-{child.pid}")):
        assert child.poll() is None
        time.sleep(0.002)
    child.send_signal(number)
    _, said = child.communicate(timeout=100)
    assert (child.returncode, said) == (-number, b"")
    assert [path.name for path in tmp_path.iterdir()] == ["long.toml"]


def test_ctrl_c_ends_what_writes_nothing(ctrl_c: None) -> None:
    child = subprocess.Popen([*COMMAND, *SPIN], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert child.stdin is not None
    # More than a pipe holds: it comes back when some of it has been read.
    child.stdin.write(b"0\n" * 100_000)
    child.stdin.flush()
    child.send_signal(signal.SIGINT)
    assert (child.communicate(timeout=100), child.returncode) == ((b"", b""), -signal.SIGINT)


def test_a_cluster_is_looked_for_in_this_python(examples: Path, tmp_path: Path) -> None:
    plan = str(examples / "sweeps" / "sleeping-threshold.toml")
    # Ray is not installed where these tests usually run, and nobody answers at that port.
    status, _, said = run(COMMAND, "sweep", plan, "--on", "ray://localhost:1", cwd=tmp_path, env={"PATH": str(tmp_path)})
    assert status != 0 and b"no python3" not in said and b"./crates/polhode-py" not in said, said


def test_it_starts_without_numpy() -> None:
    look = "import sys, polhode_command; polhode_command.main(); sys.exit('numpy' in sys.modules or 'polhode' in sys.modules)"
    assert run([sys.executable, "-c", look], "--version")[0] == 0

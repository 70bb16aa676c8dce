#!/usr/bin/env python3
"""Tries the GitHub action, the pre-commit hooks and the GitLab job with a wheel and an archive of polhode.

    python3 integrations/try.py WHEEL ARCHIVE

Each runs without Rust, Cargo and an installed polhode: the path has only TOOLS, the environment nothing but settings of the network, and
the home folder is empty. The runs check a good and a bad robot. pip installs pre-commit, and reads the YAML files with its PyYAML.
"""

from __future__ import annotations

import hashlib
import http.server
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import venv
import xml.etree.ElementTree as xml
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
ROBOTS = {"good": ROOT / "examples/robots/arm.urdf", "bad": ROOT / "examples/robots/bad-arm.urdf"}

#: Programs that a runner has. Neither Python nor a compiler is among them.
TOOLS = "awk bash cat cp curl cut env git gzip mkdir mktemp mv rm sed sh sha256sum tar unzip".split()

#: Variables of the environment that pip and curl need in some networks.
NETWORK = re.compile(r"(pip_.*|(https?|all|no)_proxy|.*_ca_bundle|ssl_cert_.*)", re.IGNORECASE)


class Machine:
    """A folder with an empty home, the tools, and a work tree for each robot."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.tools = folder / "tools"
        for name in ("tools", "home", "temporary"):
            (folder / name).mkdir()
        for tool in TOOLS:
            found = shutil.which(tool, path="/usr/bin:/bin")
            if found is None:
                raise SystemExit(f"{tool} is needed, and not in /usr/bin or /bin")
            (self.tools / tool).symlink_to(found)
        for name, robot in ROBOTS.items():
            self.repository(name, {f"robots/{robot.name}": robot})

    def repository(self, name: str, files: dict[str, Path]) -> Path:
        """Makes a repository with one commit."""
        tree = self.folder / name
        for path, source in files.items():
            (tree / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, tree / path)
        git = ["git", "-c", "user.name=tester", "-c", "user.email=tester@example.com"]
        for words in (["init", "--quiet"], ["add", "."], ["commit", "--quiet", "--message", "Files"]):
            self.run([*git, *words], tree)
        return tree

    def run(self, command: list[Any], tree: Path, status: int = 0, variables: Mapping[str, str] | None = None, path: Path | None = None) -> str:
        """Runs a command with nothing else in the environment, and returns its output."""
        network = {name: value for name, value in os.environ.items() if NETWORK.fullmatch(name)}
        places = [str(place) for place in (path, self.tools) if place]
        environment = {
            **network,
            "no_proxy": os.environ.get("no_proxy", "") + ",127.0.0.1",
            "PATH": ":".join(places),
            "HOME": str(self.folder / "home"),
            "TMPDIR": str(self.folder / "temporary"),
            "LANG": "C.UTF-8",
            **(variables or {}),
        }
        ended = subprocess.run(
            [str(word) for word in command], cwd=tree, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, encoding="utf-8"
        )
        if ended.returncode != status:
            raise SystemExit(f"exit status {ended.returncode}, expected {status}: {command}\n{ended.stdout}")
        return ended.stdout


class Releases:
    """A server with the archive as a release has it: `…/releases/download/vVERSION/NAME`, and SHA256SUMS."""

    #: Version of the release, not that of the program.
    version = "7.8.9"

    def __init__(self, folder: Path, archive: Path) -> None:
        files = folder / f"someone/fork/releases/download/v{self.version}"
        files.mkdir(parents=True)
        name = f"polhode-{self.version}-x86_64-unknown-linux-musl.tar.gz"
        shutil.copy(archive, files / name)
        (files / "SHA256SUMS").write_text(f"{'0' * 64}  other.tar.gz\n{sha256(archive)}  {name}\n")
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
        self.address = f"http://127.0.0.1:{self.server.server_address[1]}"
        self.archive = f"{self.address}/{(files / name).relative_to(folder)}"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()


class Quiet(http.server.SimpleHTTPRequestHandler):
    """Serves files without a log."""

    def log_message(self, *words: object) -> None:
        pass


def sha256(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


def expect(holds: bool, what: str, found: object = "") -> None:
    if not holds:
        raise SystemExit(f"not as expected: {what}\n{found}")


def try_action(machine: Machine, action: dict[str, Any], archive: Path, releases: Releases) -> None:
    """Runs the steps of the action as the runner does, with each way to name the archive."""
    temporary = machine.folder / "runner"
    temporary.mkdir()

    def steps(tree: str, status: int, **given: str) -> str:
        summary = temporary / "summary.md"
        summary.write_text("")
        names = {name.replace("-", "_") for name in action["inputs"]}
        expect(set(given) <= names, "inputs of the action", names)
        values = {f"inputs.{name}": given.get(name.replace("-", "_"), about["default"]) for name, about in action["inputs"].items()}
        values |= {"runner.temp": str(temporary), "github.action_repository": "someone/fork"}
        runner = {"RUNNER_OS": "Linux", "RUNNER_ARCH": "X64", "GITHUB_SERVER_URL": releases.address, "GITHUB_STEP_SUMMARY": str(summary)}
        output = ""
        for step in action["runs"]["steps"]:
            variables = {name: re.sub(r"\$\{\{ (.*?) \}\}", lambda found: values[found[1]], text) for name, text in step["env"].items()}
            script = temporary / "step.sh"
            script.write_text(step["run"])
            last = step is action["runs"]["steps"][-1] or status == 2
            shell = ["bash", "--noprofile", "--norc", "-eo", "pipefail", script]
            output += machine.run(shell, machine.folder / tree, status if last else 0, runner | variables)
            if status == 2:
                break
        return output + summary.read_text()

    exact = {"archive": str(archive), "sha256": sha256(archive)}
    output = steps("bad", 1, **exact, paths="robots", sarif="check.sarif", fail_on="impossible")
    expect("::error file=robots/bad-arm.urdf,line=" in output, "annotations", output)
    expect("| " in output and "inertia.triangle" in output, "a summary", output)
    log = json.loads((machine.folder / "bad/check.sarif").read_text())
    rules = [result["ruleId"] for result in log["runs"][0]["results"]]
    expect(log["version"] == "2.1.0" and "inertia.triangle" in rules, "findings in SARIF", log)
    steps("good", 0, **exact, paths="robots", sarif="check.sarif")
    log = json.loads((machine.folder / "good/check.sarif").read_text())
    expect(log["runs"][0]["results"] == [], "no findings in SARIF", log)
    steps("bad", 1, archive=releases.archive, sha256=exact["sha256"])
    steps("bad", 1, version=releases.version)
    for wrong, said in (
        ({}, "either archive with sha256, or version alone"),
        ({**exact, "version": "7.8.9"}, "either archive with sha256, or version alone"),
        ({"archive": str(archive)}, "either archive with sha256, or version alone"),
        ({"archive": str(archive), "sha256": "0" * 64}, f"is {exact['sha256']}, expected {'0' * 64}"),
        ({"version": "7.8.0"}, "SHA256SUMS cannot be downloaded"),
    ):
        output = steps("bad", 2, **wrong)
        expect("::error title=polhode::" in output and said in output, said, output)


def try_hooks(machine: Machine, python: Path, hook: dict[str, Any], wheel: Path, archive: Path) -> None:
    """Runs pre-commit with the hook of the book, from the wheel, and with that of the repository, from the path."""
    [dependency] = hook["hooks"][0]["additional_dependencies"]
    expect(re.match(r"polhode( @ https://|==)", dependency) is not None, "the hook of the book installs polhode", hook)
    hook["hooks"][0]["additional_dependencies"] = [f"polhode @ {wheel.as_uri()}#sha256={sha256(wheel)}"]
    # pre-commit reads `.pre-commit-hooks.yaml` in a clone.
    hooks = machine.repository("hooks", {".pre-commit-hooks.yaml": ROOT / ".pre-commit-hooks.yaml"})
    commit = machine.run(["git", "rev-parse", "HEAD"], hooks).strip()
    shared = {"repo": str(hooks), "rev": commit, "hooks": [{"id": "polhode-check"}]}
    program = unpack(machine, archive)
    for repository, path in ((hook, None), (shared, program)):
        for name, robot in ROBOTS.items():
            tree = machine.folder / name
            # JSON is YAML.
            (tree / ".pre-commit-config.yaml").write_text(json.dumps({"repos": [repository]}))
            command = [python.with_name("pre-commit"), "run", "--all-files", "--verbose"]
            output = machine.run(command, tree, status=int(name == "bad"), path=path)
            rule = "inertia.triangle" in output and robot.name in output
            expect(rule == (name == "bad") and "no files to check" not in output, f"the {name} robot", output)
    # Without a program on the path the hook fails.
    machine.run(command, machine.folder / "good", status=1)
    # A wheel with another sum is not installed.
    hook["hooks"][0]["additional_dependencies"] = [f"polhode @ {wheel.as_uri()}#sha256={'0' * 64}"]
    (machine.folder / "good/.pre-commit-config.yaml").write_text(json.dumps({"repos": [hook]}))
    expect("0" * 64 in machine.run(command, machine.folder / "good", status=3), "the sum of the wheel is compared")


def unpack(machine: Machine, archive: Path) -> Path:
    folder = machine.folder / "program"
    folder.mkdir()
    machine.run(["tar", "-xzf", archive, "-C", folder, "--strip-components", "1"], folder)
    return folder


def try_job(machine: Machine, job: dict[str, Any], archive: Path, releases: Releases) -> None:
    """Runs the script of the job as GitLab does: its commands in one shell, up to the first failure."""
    quality, junit = (job["artifacts"]["reports"][kind] for kind in ("codequality", "junit"))
    exact = {"POLHODE_ARCHIVE": str(archive), "POLHODE_SHA256": sha256(archive), "POLHODE_PATHS": "robots"}

    def script(name: str, status: int, **given: str) -> tuple[str, Path]:
        tree = machine.folder / name
        for report in (quality, junit):
            (tree / report).unlink(missing_ok=True)
        variables = {**job["variables"], **exact, **given}
        expect(set(variables) == set(job["variables"]), "variables of the job", variables)
        shell = ["bash", "-eo", "pipefail", "-c", "\n".join(job["script"])]
        return machine.run(shell, tree, status, variables), tree

    for given in ({}, {"POLHODE_ARCHIVE": releases.archive, "POLHODE_OPTIONS": "--root robots --fail-on impossible"}):
        output, tree = script("bad", 1, **given)
        expect("inertia.triangle" in output, "findings in the log", output)
        found = json.loads((tree / quality).read_text())
        rules = [finding["check_name"] for finding in found if finding["location"]["path"] == "robots/bad-arm.urdf"]
        expect("inertia.triangle" in rules, "findings in the code quality report", found)
        expect(int(xml.parse(tree / junit).getroot().get("failures", "0")) > 0, "failures in JUnit")
    _, tree = script("good", 0)
    expect(json.loads((tree / quality).read_text()) == [], "no findings in the code quality report")
    for wrong, status in (({"POLHODE_SHA256": "0" * 64}, 1), ({"POLHODE_SHA256": ""}, 1), ({"POLHODE_ARCHIVE": ""}, 2)):
        output, tree = script("bad", status, **wrong)
        expect(not (tree / quality).exists() and "inertia.triangle" not in output, f"nothing runs with {wrong}", output)


def documented(python: Path) -> list[Any]:
    """Returns the YAML blocks of the book's page."""
    page = (ROOT / "book/check-ci.md").read_text(encoding="utf-8")
    return [parsed(python, block) for block in re.findall(r"```yaml\n(.*?)```", page, re.DOTALL)]


def parsed(python: Path, text: str) -> Any:
    """Parses YAML with the PyYAML of the environment."""
    program = "import json, sys, yaml; json.dump(yaml.safe_load(sys.stdin), sys.stdout)"
    return json.loads(subprocess.run([python, "-c", program], input=text, stdout=subprocess.PIPE, check=True, text=True).stdout)


def main(wheel: Path, archive: Path) -> None:
    with tempfile.TemporaryDirectory(prefix="polhode-") as name:
        folder = Path(name).resolve()
        venv.create(folder / "environment", with_pip=True)
        python = folder / "environment/bin/python"
        subprocess.run([python, "-m", "pip", "install", "--quiet", "pre-commit==4.6.0"], check=True)
        (folder / "machine").mkdir()
        machine = Machine(folder / "machine")
        (folder / "served").mkdir()
        releases = Releases(folder / "served", archive)
        action = parsed(python, (ROOT / "integrations/github-action/action.yml").read_text(encoding="utf-8"))
        job = parsed(python, (ROOT / "integrations/gitlab/polhode.yml").read_text(encoding="utf-8"))["polhode"]
        github, gitlab, hooks = documented(python)
        expect(set(github[0]["with"]) <= set(action["inputs"]), "inputs in the book", github)
        expect(set(gitlab["polhode"]["variables"]) <= set(job["variables"]), "variables in the book", gitlab)
        try_action(machine, action, archive, releases)
        print("   the GitHub action passed")
        try_job(machine, job, archive, releases)
        print("   the GitLab job passed")
        try_hooks(machine, python, hooks[0], wheel, archive)
        print("   the pre-commit hooks passed")


if __name__ == "__main__":
    match sys.argv[1:]:
        case [wheel, archive]:
            main(Path(wheel).resolve(), Path(archive).resolve())
        case _:
            sys.exit(__doc__)

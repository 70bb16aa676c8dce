"""JupyterLab in Chromium: a motion that is displayed, the widget, and both of them where there is no kernel any more."""

from __future__ import annotations

import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import nbformat
import numpy as np
import polhode
import pytest
from nbconvert import HTMLExporter
from playwright.sync_api import Browser, FrameLocator, Page, sync_playwright

#: The browser, as the tests of the page itself find it; the gate says where it is, or installs it.
CHROMIUM = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome-stable", "google-chrome"))), None)
#: WebGL in software, as `viewer/test/browser.mjs` has it.
ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-gpu-compositing", "--disable-gpu-rasterization"]

#: Where pictures are left for who asks for them.
PICTURES = os.environ.get("POLHODE_PICTURES")

CELLS = [
    """
import polhode
from polhode.scenario import Part, Run, Start
racket = polhode.Scenario(
    Part(shape="box", size=["20 cm", "13 cm", "3 cm"], mass="0.6 kg"),
    start=Start(omega=["0.01 rad/s", "5 rad/s", "0.02 rad/s"]),
    run=Run(duration=10, samples=1001),
    title="A racket",
)
polhode.simulate(racket)""",
    """
live = polhode.widget(racket, {"start.omega[1]": (0, 20), "body[0].mass": None, "body[0].size[1]": polhode.Knob(label="width")})
live""",
    "polhode.FreeMotion(moments=[1, 2, 3], omega=[0.01, 1, 0.01])",
]
SPIN = '.polhode-knob[data-key="start.spin.body[1]"]'
MASS = '.polhode-knob[data-key="body.part[0].mass"]'



class Lab(NamedTuple):
    address: str
    token: str
    root: Path
    environment: dict[str, str]


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """JupyterLab on a free port of this machine, with a token and with folders of its own."""
    folder = tmp_path_factory.mktemp("lab")
    root, settings = folder / "root", folder / "config" / "labconfig"
    root.mkdir()
    settings.mkdir(parents=True)
    quiet = {"@jupyterlab/apputils-extension:notification": {"fetchNews": "false", "checkForUpdates": False}}
    (settings / "default_setting_overrides.json").write_text(json.dumps(quiet))
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    own = {"JUPYTER_CONFIG_DIR": "config", "JUPYTER_DATA_DIR": "data", "JUPYTER_RUNTIME_DIR": "run", "IPYTHONDIR": "ipython"}
    environment = {**os.environ, "JUPYTER_PREFER_ENV_PATH": "1", **{name: str(folder / place) for name, place in own.items()}}
    token = secrets.token_hex(16)
    said = (folder / "log").open("wb")
    server = subprocess.Popen(
        [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}", f"--IdentityProvider.token={token}"]
        + [f"--ServerApp.root_dir={root}", "--ServerApp.port_retries=0", "--LabApp.expose_app_in_browser=True", "--ServerApp.log_level=ERROR"],
        env=environment,
        cwd=folder,
        stdout=said,
        stderr=said,
    )
    try:
        address, until = f"http://127.0.0.1:{port}", time.monotonic() + 60
        while not answers(f"{address}/api/status?token={token}"):
            assert server.poll() is None and time.monotonic() < until, (folder / "log").read_text()
            time.sleep(0.1)
        yield Lab(address, token, root, environment)
    finally:
        server.terminate()
        server.wait(30)
        said.close()


def answers(address: str) -> bool:
    try:
        with urllib.request.urlopen(address, timeout=5):
            return True
    except OSError:
        return False


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield started
        started.close()


class Opened(NamedTuple):
    page: Page
    problems: list[str]


def opened(browser: Browser, lab: Lab, name: str, dark: bool = False) -> Opened:
    page = browser.new_page(viewport={"width": 1280, "height": 1200}, reduced_motion="reduce")
    page.set_default_timeout(180_000)
    problems: list[str] = []
    page.on("pageerror", lambda error: problems.append(str(error)))
    page.goto(f"{lab.address}/doc/tree/{name}?token={lab.token}")
    page.wait_for_function("window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'")
    if dark:
        page.evaluate("window.jupyterapp.commands.execute('apputils:change-theme', { theme: 'JupyterLab Dark' })")
        page.wait_for_function("document.body.dataset.jpThemeLight === 'false'")
    return Opened(page, problems)


def picture(page: Page, name: str) -> None:
    if PICTURES:
        page.screenshot(path=Path(PICTURES) / f"{name}.png")


def viewer(page: Page, of: str) -> FrameLocator:
    """A viewer that shows a motion."""
    frame = page.frame_locator(f"{of} iframe").first
    frame.locator("#time-end").filter(has_text="s").wait_for()
    return frame


def is_drawn(frame: FrameLocator) -> bool:
    """Whether the canvas is not all of one colour."""
    colours = """() => {
        const copy = Object.assign(document.createElement("canvas"), { width: 200, height: 200 }).getContext("2d");
        copy.drawImage(window.polhode.picture(), 0, 0, 200, 200);
        return new Set(new Uint32Array(copy.getImageData(0, 0, 200, 200).data.buffer)).size;
    }"""
    return bool(frame.locator("#canvas").evaluate(colours) > 20)


def shown_omega(frame: FrameLocator) -> np.ndarray:
    """What the page has of ω, (n, 3)."""
    return np.array(frame.locator("#canvas").evaluate("() => [...window.polhode.app.motion.omega]")).reshape(-1, 3)


def of_kernel(page: Page, expression: str) -> Any:
    """What the kernel makes of an expression, as JSON."""
    ask = """async code => {
        const kernel = window.jupyterapp.shell.currentWidget.sessionContext.session.kernel;
        let said = "";
        const asked = kernel.requestExecute({ code, store_history: false });
        asked.onIOPub = ({ header, content }) => { said += header.msg_type === "stream" ? content.text : (content.ename ? `${content.ename}: ${content.evalue}` : ""); };
        await Promise.race([asked.done, new Promise((_, late) => setTimeout(() => late(new Error("no answer of the kernel")), 180_000))]);
        return said;
    }"""
    said = page.evaluate(ask, f"import json; print(json.dumps(({expression})))")
    return json.loads(said) if said.startswith(tuple("[{\"-0123456789tfn")) else pytest.fail(said)


def test_a_widget_in_jupyterlab(browser: Browser, lab: Lab) -> None:
    cells = [nbformat.v4.new_code_cell(source.strip()) for source in CELLS]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), lab.root / "live.ipynb")
    page, problems = opened(browser, lab, "live.ipynb")
    # The notebook takes the focus once more at the end.
    page.evaluate("void window.jupyterapp.commands.execute('notebook:run-all-cells').then(() => { window.hasRun = true; })")
    page.wait_for_function("window.hasRun")

    # The output of a motion, and the widget.
    racket = polhode.simulate("title = 'A racket'\n" + RACKET)
    output, widget = viewer(page, ".polhode-motion"), viewer(page, ".polhode-widget")
    assert is_drawn(output) and is_drawn(widget)
    for frame in (output, widget):
        assert abs(shown_omega(frame) - racket.omega).max() < 1e-8
    page.locator(".polhode-widget").scroll_into_view_if_needed()
    picture(page, "light")

    # Labels have units, and knobs are turned from the keyboard.
    slider = page.get_by_label("ωy, rad/s").first
    assert slider.get_attribute("aria-valuetext") == "5 rad/s"
    slider.press("PageUp")
    widget.locator("#panels").get_by_text("7.0000").first.wait_for()
    assert of_kernel(page, "live.values['start.spin.body[1]'], live.motion.omega[0, 1]") == [7.0, 7.0]
    assert shown_omega(widget)[0, 1] == pytest.approx(7.0, rel=1e-8)

    # The last of many values is shown, and few of them were computed.
    of_kernel(page, "live.observe(lambda change: counted.append(change['new']), 'asked') or globals().update(counted=[])")
    for _ in range(40):
        page.keyboard.press("ArrowRight")
    widget.locator("#panels").get_by_text("15.000").first.wait_for()
    assert of_kernel(page, "live.motion.omega[0, 1]") == 15.0 and of_kernel(page, "len(counted)") <= 40

    # Python moves the knob.
    of_kernel(page, "setattr(live, 'values', {'start.spin.body[1]': 3})")
    widget.locator("#panels").get_by_text("3.0000").first.wait_for()
    assert slider.get_attribute("aria-valuetext") == "3 rad/s"

    # What is refused is said, and the motion stays.
    before = shown_omega(widget)
    mass = page.locator(f"{MASS} input[type=number]")
    mass.fill("-2")
    mass.press("Enter")
    refusal = page.get_by_role("alert").filter(has_text="must be positive")
    refusal.wait_for()
    assert "The motion is that of before." in refusal.inner_text() and mass.get_attribute("aria-invalid") == "true"
    assert (shown_omega(widget) == before).all() and of_kernel(page, "live.values['body.part[0].mass']") == 0.6
    picture(page, "refused")
    page.keyboard.press("Tab")
    while not page.evaluate("document.activeElement.matches('.polhode-refusal button')"):
        page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert not refusal.is_visible() and mass.input_value() == "0.6"

    # The colours are those around.
    page.evaluate("window.jupyterapp.commands.execute('apputils:change-theme', { theme: 'JupyterLab Dark' })")
    widget.locator("html[data-theme=dark]").wait_for(state="attached")
    picture(page, "dark")
    # What the notebook stores follows the knobs once they rest.
    page.wait_for_timeout(1500)
    page.evaluate("window.jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_function("!window.jupyterapp.shell.currentWidget.context.model.dirty")
    assert problems == []
    page.close()


RACKET = """
[[body.part]]
shape = "box"
size = ["20 cm", "13 cm", "3 cm"]
mass = "0.6 kg"
[start]
spin = { body = ["0.01 rad/s", "5 rad/s", "0.02 rad/s"] }
[run]
duration = 10
samples = 1001
"""


def test_a_notebook_without_its_kernel(browser: Browser, lab: Lab, tmp_path: Path) -> None:
    saved = lab.root / "live.ipynb"
    assert saved.exists(), "the test before saves it"
    # What was run elsewhere is trusted by who says so.
    shutil.copy(saved, lab.root / "again.ipynb")
    subprocess.run([sys.executable, "-m", "nbformat.sign", lab.root / "again.ipynb"], env=lab.environment, check=True, capture_output=True)
    page, problems = opened(browser, lab, "again.ipynb")
    shown = viewer(page, ".jp-Cell:nth-of-type(1) .polhode-motion")
    assert is_drawn(shown) and of_kernel(page, "'polhode' in globals()") is False and problems == []
    # In the widget's place is the motion that it showed last.
    cell = page.locator(".jp-Cell").nth(1)
    cell.scroll_into_view_if_needed()
    last = viewer(page, ".jp-Cell:nth-of-type(2) .polhode-motion")
    assert is_drawn(last) and (shown_omega(last)[0, 1]).round(2) == 3.0
    assert cell.locator(".polhode-widget").count() == 0 and not page.get_by_text("Error displaying widget").is_visible()
    picture(page, "again")
    page.close()

    # A page of nbconvert's has all three, the widget's as an output.
    (tmp_path / "live.html").write_text(HTMLExporter().from_filename(str(saved))[0], "utf-8")
    page = browser.new_page(reduced_motion="reduce")
    page.set_default_timeout(180_000)
    page.route("**/*", lambda route: route.continue_() if route.request.url.startswith(("file:", "data:", "blob:")) else route.abort())
    page.goto((tmp_path / "live.html").as_uri())
    frames = page.locator(".polhode-motion iframe")
    frames.nth(2).wait_for()
    assert frames.count() == 3
    for k in range(3):
        # What is not seen is not drawn.
        frames.nth(k).scroll_into_view_if_needed()
        frame = page.frame_locator(".polhode-motion iframe").nth(k)
        frame.locator("#time-end").filter(has_text="s").wait_for()
        assert is_drawn(frame)
    picture(page, "converted")
    page.close()

"""The browser's part: the page /compare in Chromium, by bench/web/compare.ts."""

import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import tempfile

from .cases import SIDES
from .progress import say
from .store import ROOT


def missing():
    """Why it cannot be measured here, or None."""
    node = shutil.which("node", path=f"{ROOT}/.setup/bin:{os.environ.get('PATH', '')}")
    if not node:
        return "no Node"
    if not shutil.which(os.environ.get("CHROMIUM", "chromium")):
        return "no Chromium"
    for needed in ("apps/web/dist/compare/index.html", "node_modules/playwright-core/package.json"):
        if not (ROOT / needed).exists():
            return f"no {needed}; ./dev bench paper --only chromium makes it"
    return None


def hash_of_page():
    """Which page measured."""
    whole = hashlib.sha256()
    for path in sorted((ROOT / "apps/web/dist").rglob("*")):
        if path.is_file():
            whole.update(path.read_bytes())
    return "sha256:" + whole.hexdigest()[:16]


def run(machine, quick, most_side, fresh=False):
    """Whether it is measured: now, or by the same page before."""
    reason = missing()
    if reason:
        say(f"the browser's part is not measured: {reason}")
        return False
    options = ["--quick"] if quick else ["--most", str(min(most_side, max(SIDES)) ** 2)]  # as far as the paper goes
    head = {"command": " ".join(["node bench/web/compare.ts", *options]), "page": hash_of_page()}
    if not fresh and head.items() <= machine.experiment("chromium").items():
        say(f"the page /compare: stored in {machine.path}")
        return True
    with tempfile.TemporaryDirectory() as folder:
        answer = pathlib.Path(folder) / "compare.json"
        environment = dict(os.environ, PATH=f"{ROOT}/.setup/bin:{os.environ.get('PATH', '')}")
        say("the page /compare in Chromium")
        done = subprocess.run(
            ["node", "bench/web/compare.ts", *options, "--json", str(answer)],
            cwd=ROOT,
            env=environment,
            stdout=subprocess.DEVNULL,
            check=False,
        )
        if done.returncode != 0 or not answer.exists():
            say(f"bench/web/compare.ts ended with exit code {done.returncode}; what it measured is not kept")
            return False
        report = json.loads(answer.read_text())
    machine.data["experiments"]["chromium"] = {**head, **report}
    machine.save()
    return True

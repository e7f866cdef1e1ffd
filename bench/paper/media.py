"""The pictures and videos of the experiments: drawn by `weft run`, made small by ffmpeg.

Whole frames go to OUT/media/MACHINE/NAME-VIEW/. From them the small pictures of the report, which the repository keeps,
are packed into RESULTS/media/MACHINE/. A machine without ffmpeg only draws.
"""

import json
import pathlib
import shutil
import subprocess
import time

from .measure import check_same, hash_of
from .progress import TimeLeft, in_words, say
from .store import ROOT

PICTURE_BYTES, VIDEO_BYTES = 80_000, 400_000
VIEWS = ("wireframe", "textured")
MOMENTS = ("early", "middle", "late")
SIDES = {"quick": 40, "software": 64, "gpu": 256}  # nodes a side


def shots(quick):
    """name, its scene, frames to simulate, moments to keep. The pull begins after frame 15."""
    frames = 40 if quick else 120
    yield "hanging", "scenes/hanging.json", frames, {"late": frames - 1}
    frames, middle = (45, 28) if quick else (66, 38)
    for name in ("sphere", "armadillo") if quick else ("sphere", "armadillo", "dragon"):
        yield f"pull-{name}", f"scenes/pull-{name}.json", frames, {"early": 14, "middle": middle, "late": frames - 1}


def draw(machine, binary, out, quick, software, adapter=None, fresh=False):
    """Draws what is not drawn yet by this binary; larger sheets stand for those of a quick run."""
    side, size = SIDES["quick" if quick else "software" if software else "gpu"], "640,360" if quick else "960,540"
    binary_hash = hash_of(binary)
    stored = {(row["name"], row["view"]): row for row in machine.rows("pictures")}
    waiting, clock = [], TimeLeft()
    for name, scene, frames, moments in shots(quick):
        for view in VIEWS:
            options = [
                "--set",
                f"cloths.0.grid=[{side},{side}]",
                "--set",
                f"render.view={view}",
                "--set",
                f"render.size=[{size}]",
                "--frames",
                str(frames),
            ]
            row = {
                "name": name,
                "view": view,
                "side": side,
                "frames": frames,
                "moments": moments,
                "files": {},
                "scene": scene,
                "command": " ".join(["weft run", scene, *options]),
                "binary": binary_hash,
            }
            before = stored.get((name, view), {})
            drawn = before.get("files") or (out / "media" / machine.name / f"{name}-{view}").is_dir()
            same = before.get("command") == row["command"] or before.get("side", 0) > side
            if fresh or not drawn or not same or before.get("binary") != binary_hash:
                waiting.append((row, frames, options))
    for k, (row, frames, options) in enumerate(waiting):
        say(
            f"[{k + 1}/{len(waiting)}] {row['command']}: {in_words(clock.left(weight for _, weight, _ in waiting[k:]))}"
        )
        began = time.monotonic()
        summary = run(binary, row, options, out / "media" / machine.name / f"{row['name']}-{row['view']}", adapter)
        check_same(binary, binary_hash)
        row |= {key: summary[key] for key in ("nodes", "state_hash", "max_stretch", "crossings") if key in summary}
        machine.add("pictures", {"command": "./dev bench paper --only pictures", "adapter": summary["adapter"]}, [row])
        if shutil.which("ffmpeg"):  # each as it comes, so that a run that is cut off leaves what it has
            pack_row(machine, row, out)
        clock.add(frames, time.monotonic() - began)


def run(binary, row, options, folder, adapter):
    """The summary of `weft run`, whose pictures lie in `folder` then."""
    call = [str(binary), "run", str(ROOT / row["scene"]), *options, "--out", str(folder), "--json"]
    done = subprocess.run(
        call + (["--adapter", adapter] if adapter else []), capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise RuntimeError(f"{row['command']}: {done.stderr.strip()}")
    if not has_video(row):  # a machine whose pictures must travel has less to carry
        kept = {f"frame_{frame:05d}.png" for frame in row["moments"].values()}
        for picture in folder.glob("frame_*.png"):
            if picture.name not in kept:
                picture.unlink()
    return json.loads(done.stdout)


def has_video(row):
    return row["name"].startswith("pull-") and row["view"] == "textured"


def pack(machine, out):
    """Makes small files of everything that lies drawn under `out`."""
    if not shutil.which("ffmpeg"):
        say("no ffmpeg here: pictures are drawn, and packed where it is by --only pack")
        return
    for row in machine.rows("pictures"):
        if (out / "media" / machine.name / f"{row['name']}-{row['view']}").is_dir():
            pack_row(machine, row, out)


def pack_row(machine, row, out):
    source = out / "media" / machine.name / f"{row['name']}-{row['view']}"
    target = machine.path.parent / "media" / machine.name
    target.mkdir(parents=True, exist_ok=True)
    files = {}
    for moment, frame in row["moments"].items():
        picture = source / f"frame_{frame:05d}.png"
        if picture.exists():
            files[moment] = f"{row['name']}-{row['view']}-{moment}.jpg"
            shrink(
                ["-i", str(picture)],
                ["-frames:v", "1", "-vf", "scale=640:-2"],
                target / files[moment],
                PICTURE_BYTES,
                [["-q:v", str(q)] for q in (3, 5, 8, 12, 18, 25)],
            )
    if has_video(row) and (source / "frame_00000.png").exists():
        files["video"] = f"{row['name']}.mp4"
        shrink(
            ["-framerate", "30", "-i", str(source / "frame_%05d.png")],
            ["-vf", "scale=640:-2", "-pix_fmt", "yuv420p", "-movflags", "+faststart"],
            target / files["video"],
            VIDEO_BYTES,
            [["-crf", str(q)] for q in (26, 30, 34, 38, 42)],
        )
    if files:
        row["files"] = files
        machine.save()


def shrink(given, how, target, most, qualities):
    """The best quality that stays within `most` bytes."""
    temporary = target.with_name("tmp-" + target.name)
    for quality in qualities:
        subprocess.run(
            ["ffmpeg", "-v", "error", "-y", *given, *how, *quality, "-map_metadata", "-1", "-bitexact", str(temporary)],
            check=True,
            stdin=subprocess.DEVNULL,
        )
        if temporary.stat().st_size <= most:
            break
    else:
        temporary.unlink()
        raise RuntimeError(f"{target.name} does not fit in {most} bytes.")
    temporary.replace(target)


def file_of(machine, name):
    """A packed file, or None where it has not been kept."""
    if name is None:
        return None
    path = pathlib.Path(machine.path).parent / "media" / machine.name / name
    return path if path.exists() else None

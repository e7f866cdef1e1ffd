#!/usr/bin/env python3
"""Makes the pictures of the page's gallery, apps/web/src/gallery/*.webp: each scene at the moment that shows it best.

Usage: python3 scripts/make_gallery.py [SCENE...]
Needs: build/weft, models/ (./dev build) and an ffmpeg with libwebp.
"""

import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
OUT = ROOT / "apps/web/src/gallery"
SIZE = "768x432"  # drawn, and then made smaller: threads do not beat with the pixels
SHOWN = "384:216"
QUALITY = "55"

# Frames until the picture.
MOMENTS = {
    "balloon": 20,
    "breeze": 100,
    "creased-paper": 70,
    "drag": 90,
    "drape-armadillo": 60,
    "drape-dragon": 32,
    "drape-sphere": 50,
    "fabric": 40,
    "flag": 70,
    "flag-in-air": 25,
    "funnel": 25,
    "hammock": 70,
    "hanging": 45,
    "hanging-paper": 300,
    "incline": 40,
    "jelly": 25,
    "pull-armadillo": 45,
    "pull-dragon": 25,
    "pull-sphere": 45,
    "sewn-dress": 140,
    "sheet": 40,
    "shot": 45,
    "stack": 16,
    "torn-banner": 44,
    "twist": 80,
    "walk": 14,
}
# A small picture needs no finer sheet; its surface is drawn finer than it is simulated.
NODES = {
    "drag": 40,
    "drape-armadillo": 48,
    "drape-dragon": 28,
    "drape-sphere": 40,
    "fabric": 40,
    "flag": 56,
    "flag-in-air": 24,
    "funnel": 24,
    "hanging": 40,
    "pull-armadillo": 56,
    "pull-dragon": 28,
    "pull-sphere": 40,
    "sheet": 40,
    "shot": 40,
    "stack": 12,
    "twist": 40,
}


def weft(*options):
    subprocess.run([ROOT / "build/weft", "run", *options, "--quiet"], cwd=ROOT, check=True)


def draw(scene, folder):
    nodes = ["--nodes", str(NODES[scene]), "--set", "render.subdivide=1"] if scene in NODES else []
    weft(scene, *nodes, "--frames", str(MOMENTS[scene]), "--size", SIZE, "--no-measures", "--out", folder)
    picture = sorted(folder.glob("frame_*.png"))[-1]
    smaller = ["-vf", f"scale={SHOWN}:flags=lanczos", "-c:v", "libwebp", "-quality", QUALITY]
    ffmpeg = ["ffmpeg", "-v", "error", "-y", "-i", picture, *smaller, OUT / f"{scene}.webp"]
    subprocess.run(ffmpeg, check=True)


def main():
    OUT.mkdir(exist_ok=True)
    for scene in sys.argv[1:] or MOMENTS:
        with tempfile.TemporaryDirectory() as folder:
            draw(scene, pathlib.Path(folder) / "run")
        print(f"{scene}: {(OUT / f'{scene}.webp').stat().st_size} bytes", flush=True)


if __name__ == "__main__":
    main()

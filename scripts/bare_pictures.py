"""FOLDER FRAMES WIDTH HEIGHT: fails unless the run's pictures and video there show the cloth.

Background and object are grey; the tartan of the cloth is the picture's only colour. So a picture shows cloth where
pixels are saturated, and shows more than cloth where others are not.
"""

import subprocess
import sys
from pathlib import Path


def frames_of(path, size):
    """The frames of a picture or video, as bytes of RGB."""
    pixels = subprocess.run(
        ["ffmpeg", "-v", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
        check=True,
        capture_output=True,
    ).stdout
    assert pixels and len(pixels) % size == 0, f"{path} has {len(pixels)} bytes of pixels, no multiple of {size}"
    return [pixels[at : at + size] for at in range(0, len(pixels), size)]


def saturated_share(frame):
    """The share of pixels whose channels are at least 48 of 255 apart."""
    pixels = zip(frame[0::3], frame[1::3], frame[2::3])
    return sum(max(pixel) - min(pixel) >= 48 for pixel in pixels) / (len(frame) / 3)


def main():
    folder = Path(sys.argv[1])
    count, width, height = (int(word) for word in sys.argv[2:5])
    pictures = sorted(folder.glob("frame_*.png"))
    assert len(pictures) == count, f"{folder} has {len(pictures)} pictures, not {count}"
    shown = [(path.name, frame) for path in pictures for frame in frames_of(path, 3 * width * height)]
    video = frames_of(folder / "run.mp4", 3 * width * height)
    assert len(video) == count, f"run.mp4 has {len(video)} frames, not {count}"
    shown += [(f"frame {k} of run.mp4", frame) for k, frame in enumerate(video)]
    for name, frame in shown:
        share = saturated_share(frame)
        print(f"weft: {name}: {share:.0%} of its pixels show the tartan", file=sys.stderr)
        assert 0.05 < share < 0.95, f"{name} shows no cloth before a background"


main()

#!/usr/bin/env python3
# What contact of layers costs: loads at several levels of collision, in turns, and the median frame of each.
#     bench/layers_cost.py
#     bench/layers_cost.py --loads folded --rounds 3
# The time is that of solver and collision, the median of the last 60 frames, the least of the rounds; strain is that at
# the end. `sized` is the folded sheet of ever more vertices, its thickness 0.16 of their spacing.
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDED = "bench/folded.toml"
# Name: scene, frames, settings.
LOADS = {
    "folded 64": (FOLDED, 120, {"substeps": 6}),
    "folded 128": (FOLDED, 120, {"resolution": 128, "substeps": 10}),
    "flag": ("flag", 240, {"count_pass_through": "false", "collision_passes": 0}),
    **{f"sized {n * n}": (FOLDED, 120, {"resolution": n, "thickness": round(0.32 / (n - 1), 6), "substeps": 10,
                                        "collision_passes": 2}) for n in (32, 100, 316)},
}
LEVELS = ["none", "spheres", "discrete", "speculative", "continuous", "guaranteed"]


def parse_arguments():
    parser = argparse.ArgumentParser(description="Cost of the levels of collision.")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release", help="build folder")
    parser.add_argument("--loads", default="folded,flag", help=f"comma-separated, of: {', '.join(LOADS)}")
    parser.add_argument("--levels", default="none,speculative,guaranteed", help=f"of: {', '.join(LEVELS)}")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--threads", type=int, default=1)
    return parser.parse_args()


def run(arguments, load, level, folder):
    scene, frames, settings = LOADS[load]
    report = folder / "report.json"
    words = [arguments.bin / "nuno", "render", ROOT / scene if "/" in scene else scene, "--frames", str(frames)]
    words += ["--no-images", "--quiet", "--backend", "cpu", "--threads", str(arguments.threads)]
    words += ["--collision", level, "--json", report]
    for name, value in settings.items():
        words += ["--set", f"{name}={value}"]
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"layers_cost: {load} at {level} ended with {done.returncode}: {done.stderr.strip()}")
    return json.loads(report.read_text())


def frame_ms(frame):
    return sum(ms for stage, ms in frame["stage_ms"].items() if stage not in ("render", "encode"))


def main():
    arguments = parse_arguments()
    words = [word.strip() for word in arguments.loads.split(",")]
    loads = [name for name in LOADS if name in words or name.split()[0] in words]
    levels = [level.strip() for level in arguments.levels.split(",")]
    times = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(arguments.rounds):
            for load in loads:
                for level in levels:
                    frames = run(arguments, load, level, pathlib.Path(folder))["frames"][-60:]
                    median = statistics.median(frame_ms(frame) for frame in frames)
                    known = times.get((load, level), (median, 0, 0))
                    contacts = statistics.median(frame["count"]["contacts"] for frame in frames)
                    times[load, level] = (min(median, known[0]), frames[-1]["max_strain"], contacts)
    print(f"{'load':<16}{'level':<13}{'ms':>9}{'over first':>12}{'ns a vertex':>13}{'contacts':>10}{'strain':>8}")
    for (load, level), (ms, strain, contacts) in times.items():
        first = times[load, levels[0]][0]
        vertices = {"folded 64": 4096, "folded 128": 16384, "flag": 1617}.get(load) or int(load.split()[1])
        print(f"{load:<16}{level:<13}{ms:>9.3f}{ms / first:>12.2f}{1e6 * ms / vertices:>13.0f}{contacts:>10.0f}"
              f"{100 * strain:>7.1f}%")


if __name__ == "__main__":
    main()

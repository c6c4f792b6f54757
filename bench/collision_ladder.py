#!/usr/bin/env python3
# What each level of collision keeps apart, and what it costs: every stress scene at every level from several jittered
# starts, with the pairs of faces that intersect counted in every frame by the exact checker. Needs a build with tests:
#     ./test -N && bench/collision_ladder.py --seeds 10
#     bench/collision_ladder.py --scenes twist,fold --levels guaranteed --seeds 3 --keep ladder.jsonl
# A row is printed after the last seed of a scene at a level. --keep stores each run; a run that is in there
# already is not run again: one file for one build. Exit 1 where a guaranteed run intersects or does not end well.
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

GALE = {"resolution": 33, "collision_passes": 0, "jitter": 0.0005, "culling": "sound"}
# Name: scene, frames, settings.
CASES = {
    **{f"gale {wind}": ("gale", 180, {**GALE, "wind_strength": wind}) for wind in (5, 20, 40, 60)},
    "twist": ("twist", 240, {}),
    "fold": ("fold", 216, {}),
    "stack": ("stack", 120, {}),
    "roll": ("roll", 200, {}),
    "squeeze": ("squeeze", 210, {}),
    "bag": ("bag", 180, {}),
    "fast_collider": ("fast_collider", 180, {}),
}
LEVELS = ["none", "spheres", "discrete", "speculative", "continuous", "guaranteed"]
COUNTS = ["rollbacks", "standstills", "unresolved"]
ROOT = pathlib.Path(__file__).resolve().parent.parent


def parse_arguments():
    parser = argparse.ArgumentParser(description="Cost and crossings of each level of collision in the stress scenes.")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release", help="build folder")
    parser.add_argument("--scenes", help=f"comma-separated; gale is all winds; of: {', '.join(CASES)}")
    parser.add_argument("--levels", help=f"comma-separated, of: {', '.join(LEVELS)}")
    parser.add_argument("--seeds", type=int, default=1, help="starts 1 to N of each")
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--frames", type=int, help="at most so many, the start included")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--timeout", type=int, default=1200, help="seconds, of a run")
    parser.add_argument("--keep", type=pathlib.Path, help="file of runs, a JSON object a line")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="further settings of each run")
    return parser.parse_args()


def chosen(text, names):
    if text is None:
        return list(names)
    words = [word.strip() for word in text.split(",")]
    unknown = [word for word in words if not any(name.split()[0] == word or name == word for name in names)]
    if unknown:
        sys.exit(f"collision_ladder: {', '.join(unknown)} unknown; there are {', '.join(names)}")
    return [name for name in names if name in words or name.split()[0] in words]


def render(arguments, name, level, seed, folder):
    scene, frames, settings = CASES[name]
    settings = {**settings, "collision": level, "seed": seed, "threads": arguments.threads}
    frames = min(frames, arguments.frames or frames)
    command = [arguments.bin / "nuno", "render", ROOT / f"assets/scenes/{scene}.toml", "--backend", "cpu", "--quiet"]
    command += ["--frames", str(frames), "--no-images", "--mesh", "ply"]
    command += ["--out", folder, "--json", folder / "report.json", "--set", "count_pass_through=true"]
    for setting in [f"{key}={value}" for key, value in settings.items()] + arguments.set:
        command += ["--set", setting]
    try:
        ran = subprocess.run(command, capture_output=True, text=True, timeout=arguments.timeout)
        return ran.returncode, ran.stderr.strip()
    except subprocess.TimeoutExpired:
        return -1, f"not done after {arguments.timeout} s"


# Pairs that intersect, of each frame; and what the checker says of meshes that it cannot check.
def count_crossings(arguments, folder):
    meshes = sorted(folder.glob("*.ply"))
    checked = subprocess.run([arguments.bin / "tests/mesh_intersections", *meshes], capture_output=True, text=True)
    crossings = [int(line.rsplit(": ", 1)[1]) for line in checked.stdout.splitlines()]
    if checked.returncode not in (0, 1) or len(crossings) != len(meshes):
        return crossings, f"{len(crossings)} of {len(meshes)} frames checked. {checked.stderr}".strip()
    return crossings, checked.stderr.strip()


def run(arguments, name, level, seed):
    with tempfile.TemporaryDirectory(prefix="nuno-ladder-") as folder:
        folder = pathlib.Path(folder)
        code, message = render(arguments, name, level, seed, folder)
        report = folder / "report.json"
        rows = json.loads(report.read_text())["frames"][1:] if report.exists() else []
        stages = [sum(ms for stage, ms in row["stage_ms"].items() if stage not in ("render", "encode")) for row in rows]
        counts = {key: sum(row["count"].get(key, 0) for row in rows) for key in COUNTS}
        crossings, refused = count_crossings(arguments, folder)
        return {"case": name, "level": level, "seed": seed, "exit": code or (2 if refused else 0),
                "message": f"{message} {refused}".strip(), "ms": stages, "crossings": crossings, **counts,
                "strain": max((row["max_strain"] for row in rows), default=0)}


def print_row(name, level, runs):
    crossings = [count for one in runs for count in one["crossings"]]
    ms = [time for one in runs for time in one["ms"]] or [0.0]
    frames = max(len(crossings), 1)
    print(f"| {name} | {level} | {len(runs)} | {len(crossings)} | {statistics.median(ms):.1f} | "
          f"{sorted(ms)[int(0.95 * (len(ms) - 1))]:.1f} | {max(ms):.0f} | {sum(count > 0 for count in crossings)} | "
          f"{1000 * sum(crossings) / frames:.0f} | {sum(one['rollbacks'] for one in runs)} | "
          f"{sum(one['standstills'] for one in runs)} | {sum(one['unresolved'] for one in runs)} | "
          f"{max(one['strain'] for one in runs):.2f} |", flush=True)


def tell(text):
    print(text, file=sys.stderr, flush=True)


def key_of(one):
    return one["case"], one["level"], one["seed"]


def main():
    arguments = parse_arguments()
    kept = {}
    if arguments.keep and arguments.keep.exists():
        kept = {key_of(one): one for one in map(json.loads, arguments.keep.read_text().splitlines())}
    failed = False
    print("| scene | level | seeds | frames | ms median | p95 | most | intersecting frames | crossings / 1000 frames |"
          " rollbacks | standstills | unresolved | strain |")
    print("|---|---|" + "---:|" * 11, flush=True)
    for name in chosen(arguments.scenes, CASES):
        for level in chosen(arguments.levels, LEVELS):
            runs = []
            for seed in range(arguments.first_seed, arguments.first_seed + arguments.seeds):
                one = kept.get((name, level, seed)) or run(arguments, name, level, seed)
                if arguments.keep and (name, level, seed) not in kept:
                    with arguments.keep.open("a") as file:
                        file.write(json.dumps(one) + "\n")
                runs.append(one)
                bad = [frame for frame, count in enumerate(one["crossings"]) if count > 0]
                if one["exit"] != 0:
                    tell(f"{name} {level} seed {seed}: exit {one['exit']}: {one['message']}")
                if level == "guaranteed" and bad:
                    tell(f"{name} {level} seed {seed}: frames {bad[:20]} intersect")
                failed |= level == "guaranteed" and (bool(bad) or one["exit"] != 0)
            print_row(name, level, runs)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()

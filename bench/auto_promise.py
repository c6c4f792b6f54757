#!/usr/bin/env python3
# Whether `nuno auto` keeps what it promises, and what that costs over the cheapest setting that would. Every choice is run
# from another start than the one it was made for (seed 7, jittered by a ten-thousandth of the cloth's size), and held
# against a converged run of that start; beside it stands a full sweep of methods, substeps, iterations and tethers. Costs
# are medians of the frames of the whole scene, with self-collision where auto keeps it.
#     bench/auto_promise.py --bin build/release
#     bench/auto_promise.py --scenes table,twist --sizes 21 --errors 1 --budgets 4
# A row a case, then a summary. Exit 1 where fewer than 95 % of the promises of an error hold.
import argparse
import array
import json
import math
import os
import pathlib
import statistics
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
LADDER = [1, 2, 4, 8, 16, 32, 64]
EXPLICIT = ["symplectic_euler", "verlet", "rk4"]


def numbers(text):
    return [float(word) for word in text.split(",") if word]


def parse_arguments():
    parser = argparse.ArgumentParser(description="Promises of nuno auto against a full sweep.")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release", help="build folder")
    parser.add_argument("--scenes", default="seed,hang,flag,drape,swing")
    parser.add_argument("--sizes", default="13,27", help="vertices along a side of a sheet")
    parser.add_argument("--errors", type=numbers, default=[10, 3, 1, 0.3], help="percent of the size of the cloth")
    parser.add_argument("--budgets", type=numbers, default=[2, 4, 8, 16], help="milliseconds of a frame")
    parser.add_argument("--cache", help="folder of what auto remembers; a new one where it is left out")
    parser.add_argument("--no-sweep", action="store_true", help="promises alone")
    return parser.parse_args()


class Cloth:
    """A scene at a size, and what runs of it give."""

    def __init__(self, nuno, scene, size, folder, cache):
        self.nuno, self.scene, self.folder = nuno, scene, folder
        self.base = ["--set", f"resolution={size}", "--threads", "1", "--quiet"]
        self.cpu = ["--backend", "cpu"]
        self.environment = dict(os.environ, XDG_CACHE_HOME=cache)
        self.side = 1.0
        self.seconds = 0.0  # of calibration

    def call(self, words, limit=300):
        return subprocess.run([self.nuno, *words], env=self.environment, capture_output=True, text=True, timeout=limit,
                              check=False)

    def auto(self, goal):
        report = self.folder / "auto.json"
        report.unlink(missing_ok=True)
        start = time.monotonic()
        done = self.call(["auto", self.scene, *self.base, *goal, "--json", str(report)], 900)
        self.seconds += time.monotonic() - start
        if not report.exists():
            sys.exit(f"auto_promise: {self.scene}: {done.stderr.strip()}")
        return json.loads(report.read_text())

    def run(self, words, frames):
        """(positions of all frames, report); None where it goes bad or takes too long."""
        cache, report = self.folder / "run.pc2", self.folder / "run.json"
        jitter = ["--set", "seed=7", "--set", f"jitter={1e-4 * self.side}"]
        try:
            done = self.call(["render", self.scene, *self.base, *jitter, *self.cpu, *words, "--frames", str(frames + 1),
                              "--no-images", "--pc2", str(cache), "--json", str(report)], 60)
        except subprocess.TimeoutExpired:
            return None
        if done.returncode not in (0, 1):
            return None
        content = cache.read_bytes()
        points, samples = struct.unpack_from("<i", content, 16)[0], struct.unpack_from("<i", content, 28)[0]
        positions = array.array("f")
        positions.frombytes(content[32 + 12 * points:32 + 12 * points * samples])
        return positions, json.loads(report.read_text())


def words_of(setting):
    return [word for name, value in setting.items() for word in ("--set", f"{name}={value}")]


def error_percent(positions, reference, size_m):
    total = sum((a - b) * (a - b) for a, b in zip(positions, reference))
    return 100 * math.sqrt(3 * total / len(reference)) / size_m


def median_ms(report):
    return report["summary"]["stage_ms"]["simulation"]["median"]


def sweep_settings(cloth):
    for method in EXPLICIT:
        found = cloth.run(words_of({"method": method, "substeps": 0, "collision": "none"}), 2)
        if found:
            substeps = found[1]["frames"][1]["substeps"]
            for n in (substeps // 2, substeps, 2 * substeps, 4 * substeps):
                yield {"method": method, "substeps": max(n, 1)}
    for method, iterations in (("xpbd", (0, 4)), ("vbd", (0, 20))):
        for tethers in ("auto", "none"):
            for count in iterations:
                for n in LADDER:
                    yield {"method": method, "tethers": tethers, "iterations": count, "substeps": n}
    for method in ("implicit_euler", "sdirk2"):
        for n in LADDER[:-1]:
            yield {"method": method, "substeps": n}


class Point:
    """A setting of the sweep that runs to its end."""

    def __init__(self, error, early_ms, setting):
        self.error, self.early_ms, self.setting = error, early_ms, setting
        self.whole_ms = None

    def cost(self, cloth, words, frames):
        if self.whole_ms is None:
            found = cloth.run(words_of(self.setting) + words, frames)
            self.whole_ms = median_ms(found[1]) if found else math.inf
        return self.whole_ms


def sweep(cloth, reference, about):
    points = []
    for setting in sweep_settings(cloth):
        found = cloth.run(words_of({**setting, "collision": about["collision"]}), about["frames"])
        if found and len(found[0]) == len(reference):
            points.append(Point(error_percent(found[0], reference, about["size_m"]), median_ms(found[1]), setting))
    return points


def level_words(found):
    """Self-collision as auto has it."""
    return words_of({name: value for name, value in found["set"].items() if name == "collision"})


def cheapest_of(cloth, points, found):
    """By cost of the whole scene; what is dearer before layers meet is dearer later."""
    best, least = None, math.inf
    for point in sorted(points, key=lambda point: point.early_ms):
        if point.early_ms > least:
            break
        ms = point.cost(cloth, level_words(found), found["frames_looked_at"])
        if ms < least:
            best, least = point, ms
    return best


def reference_of(cloth, about):
    words = {"method": "reference", "tethers": "none", "tolerance": 1e-4, "collision": about["collision"],
             "substeps": 0 if about["collision"] == "none" else 256}
    found = cloth.run(words_of(words), about["frames"])
    return found[0] if found else None


def cost_beside(cloth, found, cheapest):
    """Cost of the choice over that of the other, run in turn; least of three."""
    ms = {0: [], 1: []}
    for _ in range(3):
        for index, words in enumerate((words_of(found["set"]), words_of(cheapest.setting) + level_words(found))):
            run = cloth.run(words, found["frames_looked_at"])
            ms[index].append(median_ms(run[1]) if run else math.inf)
    return min(ms[0]) / min(ms[1])


def check_errors(cloth, name, errors, reference, points, rows):
    for percent in errors:
        found = cloth.auto(["--error", str(percent)])
        about = found["horizon"]
        run = cloth.run(words_of({**found["set"], "collision": about["collision"]}), about["frames"])
        error = error_percent(run[0], reference, about["size_m"]) if run else math.inf
        keeping = [point for point in points if point.error <= percent]
        cheapest = cheapest_of(cloth, keeping, found)
        over = cost_beside(cloth, found, cheapest) if cheapest and found["kept"] else None
        rows.append({"goal": "error", "said": found["kept"], "kept": error <= percent, "possible": bool(keeping),
                     "over": over, "spread": error / (100 * found["error_share"])})
        print(f"{name:12} error {percent:5g} %: {error:8.3g} % {'kept' if error <= percent else 'BROKEN':6}"
              f" {'' if found['kept'] else '(said so)':9} cost over cheapest {over or math.nan:5.2f}"
              f"  {' '.join(f'{k}={v}' for k, v in found['set'].items())}"
              f"  | {' '.join(f'{k}={v}' for k, v in cheapest.setting.items()) if cheapest else 'none keeps it'}", flush=True)


def best_within(cloth, budget, points, found):
    for point in sorted(points, key=lambda point: point.error):
        if point.early_ms <= budget and point.cost(cloth, level_words(found), found["frames_looked_at"]) <= budget:
            return point.error
    return math.nan


def check_budgets(cloth, name, budgets, points, rows):
    for budget in budgets:
        found = cloth.auto(["--budget-ms", str(budget)])
        run = cloth.run(words_of(found["set"]), found["frames_looked_at"])
        times = sorted(sum(frame["stage_ms"][stage] for stage in frame["stage_ms"] if stage not in ("render", "encode"))
                       for frame in run[1]["frames"][1:]) if run else [math.inf]
        ms, late = statistics.median(times), times[int(0.95 * len(times))]
        within = best_within(cloth, budget, points, found)
        rows.append({"goal": "budget", "said": found["kept"], "kept": ms <= budget,
                     "spread": ms / found["ms_per_frame"]})
        print(f"{name:12} budget {budget:4g} ms: {ms:7.3g} ms, 95 % {late:7.3g} {'kept' if ms <= budget else 'BROKEN':6}"
              f" {'' if found['kept'] else '(said so)':9} error {100 * found['error_share']:.2g} %,"
              f" best of the sweep {within:.2g} %"
              f"  {' '.join(f'{k}={v}' for k, v in found['set'].items())}", flush=True)


def summarise(rows):
    promised = [row for row in rows if row["goal"] == "error" and row["said"]]
    kept = sum(row["kept"] for row in promised)
    missed = [row for row in rows if row["goal"] == "error" and not row["said"]]
    print(f"errors: {kept} of {len(promised)} promises kept; {len(missed)} said to be impossible, "
          f"{sum(row['possible'] for row in missed)} of them with a setting of the sweep that keeps them")
    over = [row["over"] for row in promised if row["over"]]
    if over:
        print(f"cost over the cheapest: median {statistics.median(over):.2f}, worst {max(over):.2f}")
    for goal in ("error", "budget"):
        spread = sorted(row["spread"] for row in rows if row["goal"] == goal)
        if spread:
            print(f"measured over told, {goal}: median {statistics.median(spread):.3f},"
                  f" 95 % {spread[int(0.95 * len(spread))]:.3f}, largest {spread[-1]:.3f}")
    budgets = [row for row in rows if row["goal"] == "budget" and row["said"]]
    print(f"budgets: {sum(row['kept'] for row in budgets)} of {len(budgets)} promises kept")
    return not promised or kept >= 0.95 * len(promised)


def main():
    arguments = parse_arguments()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for scene in arguments.scenes.split(","):
            for size in numbers(arguments.sizes):
                name = f"{scene} {size:g}"
                cloth = Cloth(arguments.bin / "nuno", scene, int(size), pathlib.Path(folder), arguments.cache or folder)
                about = cloth.auto(["--error", "100"])["horizon"]
                cloth.side = about["size_m"]
                reference = reference_of(cloth, about)
                if reference is None:
                    print(f"{name:12} has no converged run")
                    continue
                points = [] if arguments.no_sweep else sweep(cloth, reference, about)
                check_errors(cloth, name, arguments.errors, reference, points, rows)
                check_budgets(cloth, name, arguments.budgets, points, rows)
                print(f"{name:12} measured by auto for all goals in {cloth.seconds:.1f} s", flush=True)
    sys.exit(0 if summarise(rows) else 1)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# What a feature that is off costs: nuno against the same program from whose sources the feature is cut out.
#     bench/feature_off.py                     instructions, exact to a few in a million on any machine
#     bench/feature_off.py --rounds 15         wall times too, in turns; for a machine that is quiet
# A cut is a few replacements in copies of source files, in a temporary folder that stands before src among includes.
# The files that it changes are compiled as the build folder compiles them, with the cut and without, and linked ahead
# of the libraries. Both have the feature off, so they must end in the same state; the script ends with 1 where they do
# not. `noise` is the program without a cut against itself, run twice. Instructions are those of valgrind's callgrind.
import argparse
import json
import pathlib
import re
import shlex
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FRAME = "nuno::Simulation::advance_frame()"
# All features off: a sheet that hangs, gravity and springs alone.
BASE = {"resolution": 32, "substeps": 80, "collision": "none", "damping": 0, "wind_strength": 0, "sleep_motion": 0}
EULER = {**BASE, "method": "symplectic_euler"}
VERLET = {**BASE, "method": "verlet"}
XPBD = {**BASE, "method": "xpbd", "substeps": 20, "tethers": "none"}
AIR = {**EULER, "wind_model": "aero", "wind_x": 5}
FORCES, FACES, PASSES = "src/solver/base/cpu_forces.h", "src/solver/base/cpu_faces.cpp", "src/sim/simulation_passes.cpp"
EULER_CPP, VERLET_CPP = "src/solver/explicit/cpu_euler.cpp", "src/solver/explicit/cpu_verlet.cpp"
STRIPS, WEIGHTS = "src/solver/xpbd/strip_motion.cpp", "src/model/spring_weights.cpp"
RENDER = "src/app/render_command.cpp"
FORMULAS = "shaders/shared/forces.h"
GROUP = "if (!group_has_force(model, weights, group)) continue;"
NO_FACES = {FORCES: [("if (f.faces) springs = springs + f.faces->force_on_block(block);", "")],
            "src/solver/base/cpu_forces.cpp": [("if (!f.faces) return;", "return;")]}
NO_DAMPER = {FORMULAS: [("damping_force(rho, velocity) + ", "")]}
NO_WIND = {FORMULAS: [(" + Vec3(Real(0.0f), Real(0.0f), wind)", "")]}
NO_SPRING_DAMPER = {EULER_CPP: [("const bool damped = s.forces.stiffness_damping > 0;",
                                 "constexpr bool damped = false;")]}
NO_BODIES = [("if constexpr (kBodies) held = push_out_of_bodies", "if (false) held = push_out_of_bodies"),
             ("if (s.bodies.bodies.empty())", "if (true)")]
# Feature: settings, files to compile, replacements by file.
FEATURES = {
    "faces: membrane, air": (EULER, [EULER_CPP, "src/solver/base/cpu_forces.cpp"], NO_FACES),
    "damper of springs": (EULER, [EULER_CPP], NO_SPRING_DAMPER),
    "damper": (EULER, [EULER_CPP], NO_DAMPER),
    "wind along z": (EULER, [EULER_CPP], NO_WIND),
    "bodies": (EULER, [EULER_CPP], {EULER_CPP: NO_BODIES}),
    "moving pins": (EULER, [EULER_CPP], {EULER_CPP: [("bodies_.place_pins(k, blocks, next.x, next.v);", "")]}),
    "springs that bend": ({**EULER, "bend_stiffness": 0}, [WEIGHTS], {WEIGHTS: [(GROUP, "if (group == 2) continue;")]}),
    "springs that shear": ({**EULER, "shear_stiffness": 0}, [WEIGHTS],
                           {WEIGHTS: [(GROUP, "if (group == 1) continue;")]}),
    "membrane, in air": (AIR, [FACES], {FACES: [("if (in.wanted.membrane) inner = membrane(x, v, at_rest);", "")]}),
    "gusts, in air": (AIR, [FACES], {FACES: [("if (!in.wanted.gusts) return wind;", "return wind;")]}),
    "sleep": (EULER, [PASSES], {PASSES: [("if (!may_sleep(stats)) run_passes(stats);", "run_passes(stats);")]}),
    "self-collision": (EULER, [PASSES], {PASSES: [
        ("const bool on_host = params_.collision != CollisionLevel::none || params_.count_pass_through;",
         "constexpr bool on_host = false;"),
        ("if (follows_the_way(params_)) respond_to_impacts(stats, interval_s);", "")]}),
    "verlet: damper": (VERLET, [VERLET_CPP], NO_DAMPER),
    "verlet: wind along z": (VERLET, [VERLET_CPP], NO_WIND),
    "verlet: bodies": (VERLET, [VERLET_CPP],
                       {VERLET_CPP: [NO_BODIES[0], ("if (p.bodies.bodies.empty())", "if (true)")]}),
    "xpbd: bodies": (XPBD, [STRIPS], {STRIPS: [
        ("if (kBodies && s.bodies) m =", "if (false) m ="), ("if (kBodies && s.last_bodies &&", "if (false &&"),
        ("if (s.bodies || s.last_bodies)", "if (false)")]}),
    "xpbd: tethers": (XPBD, [STRIPS], {STRIPS: [("for (const StripTethers& tethers : s.tethers) {",
                                                "for (const StripTethers& tethers : decltype(s.tethers){}) {")]}),
    "xpbd: forces on faces": (XPBD, [STRIPS], {STRIPS: [("return s.acceleration ? a + load(s.acceleration + at) : a;",
                                                         "return a;")]}),
    "report (whole program)": (EULER, [RENDER], {RENDER: [("if (flags.common.json.empty()) return;", "return;")]}),
    "--check (whole program)": (EULER, [RENDER], {RENDER: [
        ("if (flags.check > 0)\n        result.check = std::make_unique<PoseCheck>(simulation.model(), flags.check, "
         "simulation.thread_count());", "")]}),
}


def parse_arguments():
    parser = argparse.ArgumentParser(description="Cost of features that are off.")
    parser.add_argument("--bin", type=pathlib.Path, default=ROOT / "build/release", help="build folder, made by ninja")
    parser.add_argument("--features", default="", help="comma-separated words: those whose names have one of them")
    parser.add_argument("--frames", type=int, default=11, help="frames of a run whose instructions are counted")
    parser.add_argument("--rounds", type=int, default=0, help="runs of each program, timed in turns; 0: none")
    return parser.parse_args()


def done(words, what, folder=None):
    ran = subprocess.run([str(word) for word in words], capture_output=True, text=True, cwd=folder)
    if ran.returncode != 0:
        sys.exit(f"feature_off: {what} ended with {ran.returncode}: {ran.stderr.strip()[-2000:]}")
    return ran.stdout, ran.stderr


class Builder:
    def __init__(self, build, folder):
        self.build, self.folder = build, folder
        done(["ninja", "nuno"], "ninja", build)
        rows = json.loads((build / "compile_commands.json").read_text())
        self.commands = {row["file"]: row["command"] for row in rows}
        lines = done(["ninja", "-t", "commands", "nuno"], "ninja", build)[0].splitlines()
        links = [line for line in lines if " -o nuno " in line]
        if len(links) != 1:
            sys.exit(f"feature_off: {build} has no command that links nuno; build it with ninja first")
        self.link = shlex.split(links[0].split("&&")[1])

    # The program with these files compiled anew, after the replacements.
    def program(self, name, files, cut):
        folder = self.folder / name
        if (folder / "nuno").exists():
            return folder / "nuno"
        for file, replacements in cut.items():
            text = (ROOT / file).read_text()
            for old, new in replacements:
                if text.count(old) != 1:
                    sys.exit(f"feature_off: {file} has {text.count(old)} times, not once: {old}")
                text = text.replace(old, new)
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            (folder / file).write_text(text)
        folder.mkdir(exist_ok=True)
        objects = [self.compile(folder, file) for file in files]
        words = list(self.link)
        at = words.index("-o")
        words[at + 1] = str(folder / "nuno")
        done(words[:at] + [str(o) for o in objects] + words[at:], "linking", self.build)
        return folder / "nuno"

    def compile(self, folder, file):
        words = shlex.split(self.commands[str(ROOT / file)])
        words = words[1:] if words[0].endswith("ccache") else words
        out = folder / (pathlib.Path(file).name + ".o")
        words[words.index("-o") + 1] = str(out)
        if (folder / file).exists():
            words[words.index("-c") + 1] = str(folder / file)
        done(words[:1] + [f"-I{folder}/src", f"-I{folder}"] + words[1:] + ["-w"], f"compiling {file}", self.build)
        return out


def render(program, settings, frames, more=()):
    words = [program, "render", "hang", "--frames", str(frames), "--no-images", "--quiet", "--hash", "--backend", "cpu"]
    words += ["--threads", "1", *more]
    for name, value in settings.items():
        words += ["--set", f"{name}={value}"]
    return words


# Instructions of all frames, and the hash of the last state.
def instructions(program, settings, frames, whole):
    valgrind = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null"]
    if not whole:
        valgrind.append(f"--toggle-collect={FRAME}")
    out, told = done(valgrind + render(program, settings, frames), "valgrind")
    return int(re.search(r"Collected : (\d+)", told)[1]), out.split()[-1]


def median_ms(program, settings, folder):
    report = folder / "report.json"
    done(render(program, settings, 61, ["--json", report]), "nuno")
    return statistics.median(f["stage_ms"]["solve"] for f in json.loads(report.read_text())["frames"][1:])


def percent(a, b):
    return f"{100 * (a / b - 1):+.2f} %"


def row_of(arguments, builder, name):
    settings, files, cut = FEATURES[name]
    whole = builder.program("-".join(pathlib.Path(file).stem for file in files), files, {})
    programs = [whole, whole, builder.program(re.sub(r"\W+", "-", f"without {name}"), files, cut)]
    counts = [instructions(program, settings, arguments.frames, "whole" in name) for program in programs]
    same = len({state for _, state in counts}) == 1
    (a, _), (b, _), (without, _) = counts
    row = f"{name:<26}{a / 1e6:>10.2f}{percent(b, a):>10}{percent(a, without):>10}"
    if arguments.rounds:
        times = [[median_ms(program, settings, builder.folder) for program in programs]
                 for _ in range(arguments.rounds)]
        for least in (min, statistics.median):
            a, b, without = (least(column) for column in zip(*times))
            row += f"{a:>10.3f}{percent(b, a):>10}{percent(a, without):>10}"
    print(row if same else row + "  other state: " + " ".join(state for _, state in counts), flush=True)
    return same


def main():
    arguments = parse_arguments()
    words = [word.strip() for word in arguments.features.split(",")]
    names = [name for name in FEATURES if any(word in name for word in words)]
    if not names:
        sys.exit(f"feature_off: no feature has one of {', '.join(words)}; there are {'; '.join(FEATURES)}")
    heading = f"{'feature that is off':<26}{'Minstr':>10}{'noise':>10}{'costs':>10}"
    if arguments.rounds:
        heading += "".join(f"{word:>10}{'noise':>10}{'costs':>10}" for word in ("least ms", "median ms"))
    print(heading)
    with tempfile.TemporaryDirectory() as folder:
        builder = Builder(arguments.bin.resolve(), pathlib.Path(folder))
        same = [row_of(arguments, builder, name) for name in names]
    sys.exit(0 if all(same) else 1)


if __name__ == "__main__":
    main()

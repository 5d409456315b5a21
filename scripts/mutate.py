#!/usr/bin/python3
"""Do the tests notice a fault?  Puts one-line faults ("mutants") into a copy of the source, one at a time, and runs the
tests of the module that holds the fault.  A mutant is killed when a test fails, crashes or does not end.

    scripts/mutate.py [MODULE|FILE...]          all of scripts/mutants.txt, or those of modules or files
    scripts/mutate.py --continue                those that have no result from an earlier run (build/mutants.json)
    scripts/mutate.py --table docs/mutants.md   and write the table of all results

The copy stands in build/mutants and is built with preset dev; only what a mutant changes is built again.  --here saves the
copy where the checkout is one that may be spoiled: an interrupted run leaves a mutant in it.  Exit code 1:
a mutant survived that scripts/mutants.txt does not explain, or an explained one was killed.

scripts/mutants.txt: a line that starts in the first column names a source file; below it, indented by two spaces,
"original => replacement", where the original text stands exactly once in the file.  Below a mutant that survives for a
reason, indented by four spaces: "survives: REASON".  '#' starts a comment line.
"""

import argparse
import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutants"
BUILD = COPY / "build" / "dev"

# The test program of each module.
PROGRAMS = {
    "forces": "forces_tests",
    "fem": "fem_tests",
    "fem/moving": "fem_moving_tests",
    "haptics": "haptics_tests",
    "simulation": "simulation_tests",
}
# Campaigns over every model, which take minutes and repeat the checks of shorter tests, and tests that wait for a
# socket.
LEFT_OUT = {"simulation_tests": "-*Campaign*:RealTime*:*real_time*:ForceRanges*", "haptics_tests": "-Haply*"}
RESULTS = ROOT / "build" / "mutants.json"  # the test that killed each mutant, by its text
LEAST_LIMIT = 60.0  # s after which a test program counts as hung

Mutant = collections.namedtuple("Mutant", "file original replacement reason")


def read_mutants(path):
    mutants, file = [], None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        where = f"{path.name}:{number}"
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        if line.startswith("    "):
            word, reason = line.strip().split(":", 1)
            if word != "survives" or not mutants:
                sys.exit(f"{where}: expected 'survives: REASON' below a mutant")
            mutants[-1] = mutants[-1]._replace(reason=reason.strip())
        elif line.startswith("  "):
            parts = line[2:].split(" => ")
            if len(parts) != 2 or file is None:
                sys.exit(f"{where}: expected 'original => replacement' below a file")
            mutants.append(Mutant(file, parts[0], parts[1].rstrip(), ""))
        else:
            file = line.strip()
    return mutants


def check(mutants):
    for mutant in mutants:
        source = ROOT / mutant.file
        count = source.read_text().count(mutant.original) if source.exists() else 0
        if count != 1:
            sys.exit(f"{mutant.file}: '{mutant.original}' stands there {count} times, expected once")


def module_of(file):
    below = str(pathlib.Path(file).parent.relative_to("src"))
    while below not in PROGRAMS:
        if "/" not in below:
            sys.exit(f"{file}: no tests are known for this module")
        below = below.rsplit("/", 1)[0]
    return below


def key_of(mutant):
    return f"{mutant.file}: {mutant.original} => {mutant.replacement}"


def run(command, **options):
    return subprocess.run(command, cwd=COPY, capture_output=True, text=True, **options)


def make_copy():
    """The files that git knows, as they stand; those that have not changed keep their time."""
    files = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                           capture_output=True, check=True).stdout.decode().split("\0")
    wanted = {name for name in files if name and (ROOT / name).is_file()}
    for name in wanted:
        source, target = ROOT / name, COPY / name
        if target.exists() and target.read_bytes() == source.read_bytes():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source, target)
        shutil.copymode(source, target)
    for path in (COPY / "src").rglob("*.*"):
        if path.is_file() and str(path.relative_to(COPY)) not in wanted:
            path.unlink()


def build(targets):
    return run(["ninja", "-C", str(BUILD), *targets])


def first_failure(output):
    found = re.search(r"\[  FAILED  \] (\S+)", output)
    return found.group(1).rstrip(",") if found else None


def suite_of(file):
    """The usual name of the tests of a file: src/forces/tracking_wall.cpp -> TrackingWall*."""
    return "".join(word.capitalize() for word in pathlib.Path(file).stem.split("_")) + "*"


def test(program, limit, tests="*"):
    """None when all tests pass, otherwise the test that failed or what happened."""
    command = [str(BUILD / "tests" / program), "--gtest_brief=1", "--gtest_fail_fast",
               "--gtest_filter=" + tests + LEFT_OUT.get(program, "")]
    try:
        result = run(command, timeout=limit)
    except subprocess.TimeoutExpired:
        return f"{program} does not end"
    if result.returncode == 0:
        return None
    return first_failure(result.stdout) or f"{program} crashes"


def baseline(programs):
    """How long each program takes without a fault, s; all must pass."""
    done = build(programs)
    if done.returncode != 0:
        sys.exit("the unchanged source does not build:\n" + done.stdout[-3000:])
    times = {}
    for program in programs:
        start = time.monotonic()
        failure = test(program, 1800)
        if failure:
            sys.exit(f"the unchanged source fails {failure}")
        times[program] = time.monotonic() - start
        print(f"{program}: passes in {times[program]:.0f} s", flush=True)
    return times


def judge(mutant, times):
    """What kills the mutant, or None; "not compiled" is a mistake in the list."""
    path = COPY / mutant.file
    sound = path.read_text()
    path.write_text(sound.replace(mutant.original, mutant.replacement))
    try:
        program = PROGRAMS[module_of(mutant.file)]
        if build([program]).returncode != 0:
            sys.exit(f"{mutant.file}: '{mutant.replacement}' does not compile")
        limit = max(LEAST_LIMIT, 5 * times[program])
        return test(program, limit, suite_of(mutant.file)) or test(program, limit)
    finally:
        path.write_text(sound)


def table(results):
    def code(text):
        return "`" + text.replace("|", "\\|") + "`"

    killed = sum(1 for _, killer in results if killer)
    lines = ["# Mutants", "",
             "One-line faults that `scripts/mutate.py` put into the source, and the first test that failed. The list is",
             "`scripts/mutants.txt`; this page is written by `scripts/mutate.py --table docs/mutants.md`.", "",
             f"{killed} of {len(results)} are killed. Each survivor is explained.", ""]
    file = None
    for mutant, killer in results:
        if mutant.file != file:
            file = mutant.file
            lines += ["" if lines[-1] else None, f"## {file}", "", "| original | replacement | killed by |", "|---|---|---|"]
        verdict = code(killer) if killer else f"**survives:** {mutant.reason or 'not explained'}"
        lines.append(f"| {code(mutant.original)} | {code(mutant.replacement)} | {verdict} |")
    return "\n".join(line for line in lines if line is not None) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("only", nargs="*", help="modules (forces) or files (src/forces/rail.cpp)")
    parser.add_argument("--here", action="store_true", help="change this checkout itself, and build in its build/dev")
    parser.add_argument("--continue", action="store_true", dest="resume", help="keep the results of an earlier run")
    parser.add_argument("--table", type=pathlib.Path, help="write the results as Markdown")
    arguments = parser.parse_args()
    mutants = read_mutants(ROOT / "scripts" / "mutants.txt")
    if arguments.only:
        mutants = [mutant for mutant in mutants
                   if mutant.file in arguments.only or module_of(mutant.file).split("/")[0] in arguments.only]
    check(mutants)
    global COPY, BUILD
    if arguments.here:
        COPY, BUILD = ROOT, ROOT / "build" / "dev"
    else:
        make_copy()
    os.environ.setdefault("CCACHE_BASEDIR", str(COPY))
    if not (BUILD / "build.ninja").exists() and run(["cmake", "--preset", "dev"]).returncode != 0:
        sys.exit("the copy in build/mutants cannot be configured; run 'cmake --preset dev' there to see why")
    known = json.loads(RESULTS.read_text()) if arguments.resume and RESULTS.exists() else {}
    left = [mutant for mutant in mutants if key_of(mutant) not in known]
    times = baseline(sorted({PROGRAMS[module_of(mutant.file)] for mutant in left})) if left else {}

    for mutant in left:
        start = time.monotonic()
        killer = known[key_of(mutant)] = judge(mutant, times)
        RESULTS.write_text(json.dumps(known, indent=1))
        print(f"{'killed  ' if killer else 'SURVIVES'} {key_of(mutant)}"
              f"  [{killer or mutant.reason or 'not explained'}; {time.monotonic() - start:.0f} s]", flush=True)
    results = [(mutant, known[key_of(mutant)]) for mutant in mutants]
    surprises = sum(1 for mutant, killer in results if bool(mutant.reason) == bool(killer))
    print(f"{sum(1 for _, killer in results if killer)} of {len(results)} killed, {surprises} not as expected")
    if arguments.table:
        arguments.table.write_text(table(results))
    sys.exit(1 if surprises else 0)


if __name__ == "__main__":
    main()

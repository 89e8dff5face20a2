#!/usr/bin/env python3
"""Plants wrong reference values in a copy of some quick cases and demands that `recompute.py` finds every one.

    tests/reference/planted_values.py cases

Each value of kind `independent` is moved up, then down, by a little more than it may be off, and must be the one that
is reported; the cases as they are must pass.
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

QUICK = ("semicircle-9", "semicircle-9-thin", "semicircle-rough-enough", "stack-bond", "overburden-10", "paper-1-blocks")
VALUE = re.compile(r'(?m)^value = (.+)\ntolerance = (.+)\nsource = .+\nkind = "independent"')


def recomputed(folder):
    """Exit status, and the lines of values that are not right."""
    program = [sys.executable, str(Path(__file__).with_name("recompute.py")), folder, "--starts", "4"]
    ran = subprocess.run(program, capture_output=True, text=True)
    return ran.returncode, [line for line in ran.stdout.splitlines()[:-1] if not re.search(r"\bok\b", line)], ran


def planted(text, beyond):
    """The case with every independent value moved, and how many there are."""
    def move(found):
        value, tolerance = float(found[1]), min(float(found[2]), 1e-5)
        return found[0].replace(f"value = {found[1]}", f"value = {value + beyond * tolerance!r}", 1)
    return VALUE.subn(move, text)


def main():
    missed = total = 0
    for beyond in (0.0, 1.5, -1.5):
        with tempfile.TemporaryDirectory() as folder:
            count = 0
            for path in Path(sys.argv[1]).rglob("*"):
                if path.stem in QUICK and path.suffix == ".toml":
                    text, many = planted(path.read_text(), beyond)
                    (Path(folder) / path.name).write_text(text)
                    count += many
                elif path.suffix == ".csv":
                    (Path(folder) / path.name).write_text(path.read_text())
            status, wrong, ran = recomputed(folder)
            expected = count if beyond else 0
            if not count or len(wrong) != expected or status != (1 if beyond else 0):
                print(f"moved by {beyond} of the tolerance: {len(wrong)} of {expected} values are found, exit {status}")
                print(ran.stdout + ran.stderr)
                missed += 1
            total += expected
    print(f"{total} wrong values planted, {'not all' if missed else 'all'} found")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main() if len(sys.argv) == 2 else __doc__)

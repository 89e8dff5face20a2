"""Compares the numbers of records before and after a change of their words.

    python3 tests/reference/same_numbers.py OLD_COMMIT

reads every snapshot of the commit and of the working tree, and fails where the fingerprint, a cell of
the table, a figure of a note, of a check or of an answer differs, or a check has another verdict. Words may
differ, and so may the place of the notes. Needs no package.
"""

import re
import subprocess
import sys
from pathlib import Path

NUMBER = re.compile(r"(?<![A-Za-z_@-])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![A-Za-z_@])")
VERDICTS = ("holds", "marked", "deviates", "VIOLATED", "not decided")


def numbers(text):
    return sorted(NUMBER.findall(text))


def parts(record):
    """The lines of each section of a record, by its heading."""
    found, name = {"head": []}, "head"
    for line in record.splitlines():
        if line in ("checks", "answer", "notes"):
            name = line
            found[name] = []
        elif line.startswith("method       joints"):
            name = "table"
            found[name] = []
        elif line.strip():
            found[name].append(line)
    return found


# Where the notes began in the lines of the table: behind eleven columns of fixed widths.
NOTES = sum((12, 8, 15, 18, 18, 8, 9, 10, 6, 6, 12)) + 11


def notes(sections):
    """The figures that are said of each method, wherever they are said."""
    said = {}
    old = [(line.split()[0], line[NOTES:]) for line in sections.get("table", [])]
    new = [(line.split()[0], line) for line in sections.get("notes", [])]
    for method, text in old + new:
        said.setdefault(method, set()).update(NUMBER.findall(text))
    return sorted((method, sorted(found)) for method, found in said.items() if found)


def summary(record):
    """What must not change."""
    sections = parts(record)
    table = sections.get("table", [])
    fixed = [line[:NOTES].split() for line in table]
    checks = []
    for line in sections.get("checks", []):
        verdict = next(v for v in VERDICTS if line.strip().startswith(v))
        joints = line.strip()[len(verdict) :].split()[0]
        checks.append((verdict, joints, numbers(line)))
    answers = [(line.split()[0], numbers(line)) for line in sections.get("answer", [])]
    return {
        "head": sections["head"],
        "table": fixed,
        "notes": notes(sections),
        "checks": checks,
        "answer": answers,
    }


def main():
    old = sys.argv[1]
    names = subprocess.run(
        ["git", "ls-tree", "--name-only", old, "snapshots/"], capture_output=True, text=True, check=True
    ).stdout.split()
    compared = wrong = 0
    for name in names:
        if name.endswith("malformed.snap"):
            continue
        text = subprocess.run(
            ["git", "show", f"{old}:{name}"], capture_output=True, text=True, check=True
        ).stdout
        before, after = summary(text), summary(Path(name).read_text())
        for part in before:
            compared += len(before[part])
            if before[part] != after[part]:
                wrong += 1
                pairs = list(zip(before[part], after[part]))
                differing = [pair for pair in pairs if pair[0] != pair[1]]
                print(f"{name}: {part}: {len(before[part])} lines, now {len(after[part])}")
                for pair in differing[:3]:
                    print("  before", pair[0], "\n  now   ", pair[1])
    print(f"{len(names)} records, {compared} lines compared, {wrong} sections differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""The files of small scenes among results, a line each: those on which a lower bound takes seconds.

    tests/reference/smallest.py results.json FOLDER COUNT BLOCKS

The first COUNT case files of FOLDER, by name, with at most BLOCKS blocks. Fails where there are fewer.
"""
import json
import sys
from pathlib import Path


def main():
    results, folder, count, blocks = sys.argv[1:]
    rows = json.loads(Path(results).read_text())
    names = sorted({row["case"].split("@")[0] for row in rows if row["blocks"] and row["blocks"] <= int(blocks)})
    if len(names) < int(count):
        sys.exit(f"{len(names)} scenes have at most {blocks} blocks, not {count}")
    for name in names[: int(count)]:
        print(Path(folder) / f"{name}.toml")


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main()

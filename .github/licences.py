#!/usr/bin/env python3
"""Prints the licences of everything that is linked into the program for a target: each crate, and
each text once, with the crates that it is of.

    .github/licences.py x86_64-unknown-linux-gnu > THIRD-PARTY.txt

Where a crate's package holds no text, it is the text of a crate of the same repository and under the
same licence, or that of the Apache License, which is the same for all; anything else ends in an error."""

import json
import pathlib
import subprocess
import sys

TEXTS = ("licen", "copying", "notice", "unlicense")


def linked(target):
    """The packages that are linked, sorted by name; not those that only help to compile."""
    command = ["cargo", "metadata", "--locked", "--format-version", "1", "--filter-platform", target]
    data = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    nodes = {node["id"]: node for node in data["resolve"]["nodes"]}
    root = data["resolve"]["root"]
    seen, waiting = set(), [root]
    while waiting:
        package = waiting.pop()
        if package not in seen:
            seen.add(package)
            for other in nodes[package]["deps"]:
                if any(kind["kind"] is None for kind in other["dep_kinds"]):
                    waiting.append(other["pkg"])
    packages = [p for p in data["packages"] if p["id"] in seen - {root}]
    return sorted(packages, key=lambda p: (p["name"], p["version"]))


def texts_of(package):
    folder = pathlib.Path(package["manifest_path"]).parent
    files = [f for f in folder.iterdir() if f.is_file() and f.name.lower().startswith(TEXTS)]
    return [f.read_text(encoding="utf-8", errors="replace").strip() for f in sorted(files)]


def main():
    packages = linked(sys.argv[1])
    crates_of, without, of_repository = {}, [], {}
    for package in packages:
        name = f"{package['name']} {package['version']}"
        texts = texts_of(package)
        source = (package["repository"], package["license"])
        if not texts:
            without.append((name, source))
        elif package["repository"]:
            of_repository.setdefault(source, texts)
        for text in texts:
            crates_of.setdefault(text, []).append(name)
    apache = [t for t in crates_of if t.startswith("Apache License") and "APPENDIX" in t]
    for name, source in without:
        texts = of_repository.get(source, apache[:1] if "Apache-2.0" in source[1] else [])
        if not texts:
            sys.exit(f"error: {name} ({source[1]}) comes without the text of its licence")
        for text in texts:
            crates_of[text].append(name)

    out = ["The program is linked with the standard library of Rust (MIT OR Apache-2.0) and these:", ""]
    for package in packages:
        authors = ", ".join(package["authors"]) or package["repository"] or ""
        out.append(f"  {package['name']} {package['version']}: {package['license']} ({authors})")
    for text, names in sorted(crates_of.items(), key=lambda item: item[1]):
        out += ["", "=" * 72, "of " + ", ".join(sorted(names)), "=" * 72, "", text]
    sys.stdout.reconfigure(encoding="utf-8", newline="\n")
    print("\n".join(out))


main()

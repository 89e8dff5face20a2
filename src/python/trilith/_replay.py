"""Hands the program an answer that a function gave already: `python _replay.py FOLDER < scene`."""

import hashlib
import json
import os
import sys


def main() -> int:
    scene = json.dumps(json.load(sys.stdin), sort_keys=True)
    name = hashlib.sha256(scene.encode()).hexdigest()
    try:
        with open(os.path.join(sys.argv[1], name), encoding="utf-8") as file:
            answer = file.read()
    except OSError:
        print("the function was not called with this scene", file=sys.stderr)
        return 1
    if answer.startswith("Traceback"):
        lines = answer.strip().splitlines()
        print(lines[-1], file=sys.stderr)
        return 1
    print(answer)
    return 0


if __name__ == "__main__":
    sys.exit(main())

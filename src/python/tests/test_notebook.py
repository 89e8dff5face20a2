"""The notebook: its cells, one after the other, as a reader runs them."""

import json
import os
from pathlib import Path

import pytest

NOTEBOOK = Path(__file__).resolve().parents[1] / "wall.ipynb"


@pytest.mark.skipif(os.name == "nt", reason="outside methods do not run on Windows")
def test_the_cells_of_the_notebook_run():
    pytest.importorskip("matplotlib").use("Agg")
    names = {}
    notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
    for number, cell in enumerate(notebook["cells"]):
        if cell["cell_type"] == "code":
            assert not cell["outputs"], "no output is stored"
            exec(compile("".join(cell["source"]), f"cell {number}", "exec"), names)
    results, curve = names["results"], names["curve"]
    assert results["interval"].status == "verified"
    lowest = curve["interval"].lower
    assert lowest == sorted(lowest), "λ grows with friction"
    assert all(a >= b - 1e-6 for a, b in zip(curve["associative"].upper, lowest))
    # The forces that are plotted hold the wall.
    assert abs(names["vectors"]).max() > 0
    verdicts = {row.case: row["verdict"] for row in names["judged"]["overturns"]}
    assert verdicts["block-slender"] == "holds" and verdicts["column-2"] == "holds"

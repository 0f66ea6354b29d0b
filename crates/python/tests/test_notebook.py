"""Jupyter, by nbconvert as people run it."""

import json
import subprocess
import sys

import pytest

pytest.importorskip("nbconvert")
pytest.importorskip("ipykernel")


def executed(tmp_path, cells, *options):
    notebook = {
        "cells": [
            {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": cell, "id": f"c{at}"}
            for at, cell in enumerate(cells)
        ],
        "metadata": {"kernelspec": {"name": "python3", "display_name": "Python 3"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    (tmp_path / "in.ipynb").write_text(json.dumps(notebook))
    done = subprocess.run(
        [sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", *options, "--output", "out.ipynb", "in.ipynb"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=300,
    )
    out = tmp_path / "out.ipynb"
    return done, json.loads(out.read_text())["cells"] if out.exists() else []


def test_magics_and_displays(tmp_path):
    done, cells = executed(
        tmp_path,
        [
            "%load_ext polarform\nimport polarform as pf",
            "pf.polar('t^3 + 3t')",
            "%%polarform\nF(t) := t^2 + 2t\nf := polar(F)\nf(0, 1) = 2\nfigure_basis(2)",
            "x = %polarform f(0, 1/2)\nx.fraction()",
            "pf.figure_bezier([[0, 0], [1, 1], [2, 0]])",
            "%%polarform --new\nf(0, 1)",
        ],
        "--allow-errors",
    )
    assert done.returncode == 0, done.stderr
    data = lambda at: [out["data"] for out in cells[at]["outputs"]]
    text = lambda part: "".join(part)
    assert text(data(1)[0]["text/latex"]).startswith("$\\displaystyle f(t_1, t_2, t_3) = ")
    shown = data(2)
    assert text(shown[0]["text/latex"]) == "$\\displaystyle F(t) := t^2 + 2 t$"
    assert text(shown[2]["text/plain"]).startswith("refuted")
    assert text(shown[3]["image/svg+xml"]).startswith("<svg")
    assert text(data(3)[0]["text/plain"]) == "Fraction(1, 2)"
    assert "image/svg+xml" in data(4)[0]
    # In a new session f is unknown, and the traceback is the place in the cell.
    (error,) = cells[5]["outputs"]
    assert error["output_type"] == "error" and "1 | f(0, 1)" in "\n".join(error["traceback"]), error
    assert not any("magic.py" in line for line in error["traceback"])

"""The wrappers and stubs of the table of functions."""

import doctest
import importlib
import inspect
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import polarform as pf
from polarform import _native, _stubs

TABLE = _native.function_table()


@pytest.mark.parametrize("name", pf.functions.__all__)
def test_every_function_is_there_with_an_example_that_runs(name):
    function = getattr(pf, name)
    assert function is getattr(pf.functions, name) and name in dir(pf)
    tests = doctest.DocTestFinder().find(function, name, globs={"pf": pf})
    assert sum(len(test.examples) for test in tests) == 1
    runner = doctest.DocTestRunner()
    for test in tests:
        assert runner.run(test).failed == 0
    assert inspect.signature(function).parameters


def test_wrappers_do_what_queries_do():
    # Each example that is one call with plain arguments, split by hand.
    for name, args, kwargs, query in [
        ("polar", ("t^2 + 2t",), {"degree": 3}, "polar(t^2 + 2t, degree=3)"),
        ("casteljau", ([[0, 0], [1, 1], [2, 0]], "1/2"), {}, "casteljau([[0, 0], [1, 1], [2, 0]], 1/2)"),
        ("derive", ("polar", "t^2"), {"method": "taylor"}, "derive(polar, t^2, method=taylor)"),
        ("bspline", (2, [0, 0, 0, 1, 2, 2, 2], [1, 2, 3, 4]), {}, "bspline(2, [0,0,0,1,2,2,2], [1,2,3,4])"),
    ]:
        assert str(getattr(pf, name)(*args, **kwargs)) == str(pf.eval(query)), name


def test_modules_are_documented_with_examples_that_run():
    for name in ["polarform", "polarform.functions", "polarform._errors"]:
        tried = doctest.testmod(importlib.import_module(name), extraglobs={"pf": pf})
        assert tried.attempted > 0 and tried.failed == 0, name
    for made in (pf.Value, pf.Session, pf.Report, pf.Finding, pf.Equation, pf.check, pf.check_file, pf.eval, pf.limits):
        assert made.__doc__, made


def test_stubs_are_up_to_date():
    stubs = Path(_stubs.__file__).with_name("functions.pyi")
    assert stubs.read_text(encoding="utf-8") == _stubs.text(), "renew them: python -m polarform._stubs crates/python/python/polarform"


def test_stubs_of_the_compiled_part_name_what_there_is():
    text = Path(_stubs.__file__).with_name("_native.pyi").read_text(encoding="utf-8")
    for name in dir(_native):
        if not name.startswith("__"):
            assert f"class {name}" in text or f"def {name}(" in text, name
    for cls in (pf.Value, pf.Session, pf.Report, pf.Finding, pf.Problem):
        for name in vars(cls):
            if not name.startswith("__"):
                assert f"def {name}(" in text or f"    {name}: " in text, (cls, name)


def test_types_are_checked(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "good.py").write_text(
        "import polarform as pf\n"
        "f: pf.Value = pf.polar('t^2', degree=3)\n"
        "words: list[str] = [x.verdict for x in pf.check('').findings]\n"
        "g: pf.Value = pf.functions.subs(f, t=3)\n"
        "n: int = int(f(0, 1, 2))\n"
    )
    (tmp_path / "bad.py").write_text("import polarform as pf\npf.polar('t^2', method='nonsense')\npf.check('', format='word')\n")
    package = Path(pf.__file__).parent
    run = lambda *what: subprocess.run([sys.executable, "-m", "mypy", "--strict", *map(str, what)], capture_output=True, text=True, cwd=tmp_path)
    good = run("good.py")
    assert good.returncode == 0, good.stdout
    bad = run("bad.py")
    assert bad.stdout.count("error:") == 2, bad.stdout
    # A copy: beside it in site-packages stand modules that mypy takes for its own.
    own = run("--ignore-missing-imports", shutil.copytree(package, tmp_path / "own" / "polarform"))
    assert own.returncode == 0, own.stdout

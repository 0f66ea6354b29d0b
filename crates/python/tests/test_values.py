"""Values, arguments, sessions, errors, limits."""

import math
import pickle
import threading
import warnings
from decimal import Decimal
from fractions import Fraction

import pytest

import polarform as pf


def test_numbers_are_fractions_and_equal_to_those_of_python():
    half = pf.eval("1/2")
    assert half.fraction() == Fraction(1, 2) and isinstance(half.fraction(), Fraction)
    assert half == Fraction(1, 2) and hash(half) == hash(Fraction(1, 2)) and half != Fraction(1, 3)
    assert (half.numerator, half.denominator, half.as_integer_ratio()) == (1, 2, (1, 2))
    assert pf.eval("3") == 3 and int(pf.eval("3")) == 3 and list(range(5))[pf.eval("3")] == 3
    big = 7**200
    assert pf.Value(big) == big and int(pf.Value(big)) == big and pf.Value(-big) * 3 == -3 * big
    assert pf.Value(Fraction(big, 3)).fraction() == Fraction(big, 3)
    assert float(half) == 0.5
    assert bool(pf.Value(0)) is False and bool(half)
    with pytest.raises(ValueError):
        int(half)
    with pytest.raises(TypeError):
        pf.eval("t").fraction()


def test_algebraic_numbers_have_the_nearest_float():
    roots = pf.roots("t^2 - 2")
    assert [float(root) for root in roots] == [-math.sqrt(2), math.sqrt(2)]
    tiny = pf.roots("(10^30 t)^3 - 2")[0]
    assert float(tiny) == pytest.approx(2 ** (1 / 3) * 1e-30, rel=1e-15)


def test_arithmetic_is_that_of_the_language():
    t = pf.symbol("t")
    assert (t + 1) ** 2 == pf.eval("t^2 + 2t + 1")
    assert 1 - t == pf.eval("1 - t") and 1 / t == pf.eval("1/t") and Fraction(1, 2) * t == pf.eval("t/2")
    assert -t == pf.eval("-t") and 2**pf.Value(10) == 1024
    assert ((t + 1) / (t - 1)).numerator == t + 1
    with pytest.raises(pf.PolarformError) as caught:
        t / 0
    assert caught.value.code == "E303"
    with pytest.raises(TypeError):
        t + 0.5
    with pytest.raises(TypeError):
        t + "1"


def test_polar_forms_are_called():
    f = pf.polar("t^3 + 3t")
    assert str(f) == "f(t1, t2, t3) = t1 t2 t3 + (t1 + t2 + t3)"
    assert f(0, 1, Fraction(1, 2)) == Fraction(3, 2) and f(0, 0, pf.vector(1)) == 1
    # An independent way: the mean over all arrangements for random arguments.
    F = lambda t: t**3 + 3 * t
    x = [Fraction(3, 7), Fraction(-5, 2), Fraction(11, 3)]
    subsets = [(sum(x[i] for i in range(3) if mask >> i & 1), bin(mask).count("1")) for mask in range(8)]
    cube = sum((-1) ** (3 - size) * total**3 for total, size in subsets) / 6
    assert f(*x) == cube + sum(x)
    assert f("s", "s", "s") == pf.eval("s^3 + 3s")
    g = pf.polar_tensor("u v", "u", "v", 2, 2)
    assert g(0, 1, 0, 1) == Fraction(1, 4)


def test_arguments_of_all_kinds():
    points = [[0, 0], (1, Fraction(1, 2)), [2, "0"]]
    curve = pf.bezier(points)
    assert curve("1/2").items() == [1, Fraction(1, 4)]
    assert curve(pf.eval("1/2")) == curve(Fraction(1, 2)) == curve(Decimal("0.5"))
    assert pf.polar("t^2", degree=3) == pf.polar(r"t^{2}", degree="3") == pf.polar(pf.symbol("t") ** 2, degree=pf.Value(3))
    assert pf.polar("t^2", degree=None) == pf.polar("t^2")
    assert pf.subs("t^2 + s", t=3) == pf.eval("9 + s")
    assert pf.change_of_basis(2, "power", "bernstein").shape == (3, 3)
    assert pf.solve(pf.Equation("x + 1", 3), "x") == pf.solve("x + 1 = 3", "x") == 2
    assert "<title>a ] &quot;b&quot;, c=1" in pf.figure_bezier(points, title='a ] "b", c=1').svg().replace("'", "&#39;")
    assert pf.functions.max(*[1, 5, 3]) == 5
    for bad in [0.1, float("nan"), 1j, None, {"a": 1}, b"t", object(), Decimal("nan")]:
        with pytest.raises(TypeError):
            pf.polar(bad)


def test_lists_matrices_tables():
    matrix = pf.eval("[1, 2; 3, 4]")
    assert matrix.shape == (2, 2) and matrix[1, 0] == 3 and matrix[-1][1] == 4 and len(matrix) == 2
    assert (matrix @ matrix)[0, 0] == 7 and pf.det(matrix) == -2
    assert [[int(x) for x in row] for row in matrix] == [[1, 2], [3, 4]]
    with pytest.raises(IndexError):
        matrix[2]
    with pytest.raises(TypeError):
        len(pf.Value(1))
    with pytest.raises(TypeError):
        iter(pf.Value(1))
    assert pf.bezier_points("t^2", 0, 1).items() == [0, 0, 1]


def test_text_latex_svg_json():
    f = pf.polar("t^2 + 2t")
    assert f.latex() == "f(t_1, t_2) = t_1 t_2 + (t_1 + t_2)"
    assert f._repr_latex_() == "$\\displaystyle f(t_1, t_2) = t_1 t_2 + (t_1 + t_2)$" and f._repr_svg_() is None
    assert f.text("unicode") == "f(t₁, t₂) = t₁t₂ + (t₁ + t₂)"
    assert f.text("sympy", notation="expanded") == "t1*t2 + t1 + t2"
    assert pf.eval("1/2").json()["kind"] == "number"
    shown = pf.derive("polar", "t^2 + 2t")._repr_latex_()
    assert shown.startswith("$$\n\\begin{aligned}") and shown.endswith("\\end{aligned}\n$$")
    picture = pf.figure_casteljau([[0, 0], [1, 1], [2, 0]], "1/2")
    assert picture._repr_svg_().startswith("<svg") and picture._repr_latex_() is None
    assert "\\begin{tikzpicture}" in picture.tikz() and "\\documentclass" in picture.tikz(standalone=True)
    assert picture.kind == "a figure" and str(picture)
    with pytest.raises(TypeError):
        f.svg()
    with pytest.raises(ValueError):
        f.text("word")


def test_claims():
    claim = pf.eval("(t + 1)^2 = t^2 + 1")
    assert claim.verdict == "refuted" and not claim
    witness = claim.counterexample
    t = witness["t"]
    assert (t + 1) ** 2 == witness["left"] and t**2 + 1 == witness["right"] != witness["left"]
    assert pf.eval("(t + 1)^2 = t^2 + 2t + 1").verdict == "proved" and pf.polar("t^2").equals(pf.polar("t^2"))
    assert pf.eval("x > 0").verdict == "undecided"
    with pytest.raises(ValueError):
        bool(pf.eval("x > 0"))
    with pytest.raises(TypeError):
        pf.Value(1).verdict


def test_sessions_keep_names():
    session = pf.Session()
    assert session.eval("F(t) := t^2; f := polar(F); f(0, 3)") == 0
    assert session.names() == ["F", "f"] and "f" in session and "g" not in session and len(session) == 2
    session["b_0"] = Fraction(1, 3)
    session["g"] = session["f"]
    assert session.eval("g(b_0, 3)") == 1 and session.eval("ans + 1") == 2
    assert session.call("diagonal", "f") == pf.eval("t^2")
    values = session.run("a := 2; a = 3; a")
    assert [value.name for value in values] == ["a", None, None] and values[1].verdict == "refuted"
    other = session.copy()
    other.eval("a := 7")
    assert session["a"] == 2 and other["a"] == 7
    del session["a"]
    with pytest.raises(KeyError):
        session["a"]
    with pytest.raises(KeyError):
        del session["a"]
    # What failed changes nothing; what stood before it is done.
    with pytest.raises(pf.PolarformError):
        session.eval("h := 1; k := 1/0; l := 2")
    assert "h" in session and "k" not in session and "l" not in session
    for bad in ["1", "", "a b", "f(t)", "polar"]:
        with pytest.raises(pf.PolarformError):
            session[bad] = 1
    assert pf.eval("f(x, 1)", f=pf.polar("t^2"), x="1/2") == Fraction(1, 2)


def test_errors_have_places():
    text = "polar(σ^2 + )"
    with pytest.raises(pf.PolarformError) as caught:
        pf.eval(text)
    error = caught.value
    start, end = error.span
    assert (error.source[start:end], error.code, error.line, error.column) == ("+", "E102", 1, 11)
    assert "polar(σ^2 + )" in str(error) and "^" in str(error) and error.hints
    with pytest.raises(pf.PolarformError) as caught:
        pf.polar("t^2", degree="-1")
    assert caught.value.source == "polar(t^2, degree=-1)" and caught.value.source[slice(*caught.value.span)] == "-1"
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.span, again.code) == (str(error), error.span, error.code)
    with pytest.raises(pf.PolarformError, match="did you mean 'degree'"):
        pf.polar("t^2", degre=3)
    with pytest.raises(pf.PolarformError):
        pf.polar("t^2, t^3")
    for empty in ["", "  ", ";"]:
        with pytest.raises(pf.PolarformError):
            pf.eval(empty)
    assert pf.explain("e103").startswith("E103: ")
    with pytest.raises(KeyError):
        pf.explain("E999")
    with pytest.raises(AttributeError):
        pf.nothing


def test_a_doubtful_reading_is_a_warning():
    session = pf.Session()
    session.run("y := 2x; x := 3")
    with pytest.warns(pf.PolarformWarning, match="x is a symbol here"):
        assert session.eval("y").notes
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pf.eval("polar(t^2)")
        with pytest.raises(pf.PolarformWarning):
            session.eval("y")


def test_limits():
    with pf.limits(max_terms=10):
        with pytest.raises(pf.LimitError):
            pf.eval("expand((x + y)^20)")
    assert pf.eval("expand((x + y)^20)")
    with pf.limits(max_digits=50), pytest.raises(pf.LimitError):
        pf.eval("2^1000")
    with pytest.raises(pf.LimitError) as caught:
        pf.Session(timeout=0.05).eval("expand((a + b + c + d + e + f)^60)")
    assert caught.value.code in ("E401", "E402") and "--timeout" not in str(caught.value)
    pf.limits(timeout=3)
    assert pf._get_limits()[0] == 3
    with pytest.raises(ValueError):
        pf.limits(timeout=-1)
    with pytest.raises(ValueError):
        pf.limits(max_depth=10**9)


def test_threads_do_not_wait_for_each_other():
    """The lock of the interpreter is free while something is calculated."""
    found = []
    calculation = threading.Thread(target=lambda: found.append(pf.eval("coefficient(expand((1 + x)^3000), x, 1500)")))
    counted = 0
    calculation.start()
    while calculation.is_alive():
        counted += 1
    assert counted > 10 and found == [math.comb(3000, 1500)]
    # And a session is changed by all of them.
    session = pf.Session()
    threads = [threading.Thread(target=session.eval, args=("1 + 1",)) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert session["ans"] == 2

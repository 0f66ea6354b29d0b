"""SymPy and numpy, there and back."""

import random
from fractions import Fraction

import pytest

import polarform as pf

sympy = pytest.importorskip("sympy")
numpy = pytest.importorskip("numpy")


def random_expression(random, depth=3):
    letters = sympy.symbols("t x y t1 b_0")
    if depth == 0 or random.random() < 0.2:
        return random.choice([*letters, sympy.Rational(random.randint(-9, 9), random.randint(1, 9))])
    left, right = random_expression(random, depth - 1), random_expression(random, depth - 1)
    kind = random.randint(0, 3)
    if kind == 3:
        return left ** random.randint(0, 3)
    return [left + right, left - right, left * right][kind]


def test_expressions_go_there_and_back():
    dice = random.Random(7)
    for _ in range(200):
        expr = random_expression(dice)
        value = pf.Value(expr)
        names = {s.name: Fraction(dice.randint(-20, 20), dice.randint(1, 7)) for s in expr.free_symbols}
        # SymPy's own value is the second way.
        wanted = expr.subs({sympy.Symbol(name): sympy.Rational(q.numerator, q.denominator) for name, q in names.items()})
        got = value
        for name, number in names.items():
            if {name, name.replace("t1", "t_1")} & {*got.variables}:
                got = pf.subs(got, name, number)
        assert got.fraction() == Fraction(int(wanted.p), int(wanted.q)), expr
        back = value.sympy()
        assert sympy.expand(back - expr) == 0, (expr, back)


def test_kinds_of_values_in_sympy():
    t = sympy.Symbol("t")
    assert pf.eval("(t + 1)/(t - 1)").sympy() == (t + 1) / (t - 1)
    assert pf.eval("E + I + pi_1").sympy() == sum(sympy.Symbol(name) for name in ["E", "I", "pi_1"])
    assert pf.eval("[1/2, t]").sympy() == [sympy.Rational(1, 2), t]
    assert pf.eval("[1, 2; 3, t]").sympy() == sympy.Matrix([[1, 2], [3, t]])
    polar = pf.polar("t^2 + 2t").sympy()
    x, y = sympy.symbols("x y")
    assert sympy.expand(polar(x, y) - (x * y + x + y)) == 0
    F = pf.Session()
    F.eval("F(t) := t^2 + s")
    assert F["F"].sympy()(3) == 9 + sympy.Symbol("s")
    basis = pf.eval("piecewise([0, 1, 2], [t, 2 - t], outside=0)").sympy()
    for at, value in [(-1, 0), (0, 0), (sympy.Rational(1, 2), sympy.Rational(1, 2)), (1, 1), (2, 0), (3, 0)]:
        assert basis.subs(t, at) == value, at
    for root in pf.roots("t^3 - 3t + 1"):
        found = root.sympy()
        assert sympy.expand(sympy.minimal_polynomial(found, t) - (t**3 - 3 * t + 1)) == 0
        assert float(found) == pytest.approx(float(root), rel=1e-14)
    with pytest.raises(TypeError):
        pf.bezier([[0, 0], [1, 1]]).sympy()


def test_what_sympy_has_and_polarform_not_is_refused():
    x = sympy.Symbol("x")
    for bad in [sympy.pi, sympy.E, sympy.I, sympy.sqrt(2), sympy.sin(x), x**sympy.Symbol("n"), sympy.Float("0.1"), sympy.oo, x < 1, sympy.true]:
        with pytest.raises(TypeError):
            pf.Value(bad)
        with pytest.raises(TypeError):
            pf.Value(bad + x if isinstance(bad, sympy.Expr) and bad is not sympy.oo else bad)


def test_arguments_of_sympy():
    t, s = sympy.symbols("t s")
    assert pf.polar(t**3 + 3 * t) == pf.polar("t^3 + 3t")
    assert pf.solve(sympy.Eq(t + 1, s), t) == pf.eval("s - 1")
    assert pf.det(sympy.Matrix([[1, t], [2, 3]])) == pf.eval("3 - 2t")
    assert pf.polar(sympy.Poly(t**2 + 1, t)) == pf.polar("t^2 + 1")
    assert pf.Value(sympy.Symbol("lambda_")) == pf.symbol("lambda")
    with pytest.raises(pf.PolarformError):
        pf.Value(sympy.Symbol("a b"))


def test_arrays():
    points = pf.bezier_points("t^3 + s t", 0, 1).numpy()
    assert points.dtype == object and points.shape == (4,) and points[0] == Fraction(0)
    assert points[1] == pf.eval("s/3")
    matrix = pf.bernstein_to_power(3)
    assert matrix.numpy().shape == (4, 4) and isinstance(matrix.numpy()[3, 0], Fraction)
    assert (matrix.numpy() @ pf.inverse(matrix).numpy() == numpy.eye(4)).all()
    assert matrix.numpy(dtype=float).dtype == float
    assert pf.Value(Fraction(1, 2)).numpy()[()] == Fraction(1, 2)
    assert pf.eval("[[1, 2], [3]]").numpy().shape == (2,)
    assert pf.Value(numpy.int64(3)) == 3 and pf.Value(numpy.array([[1, 2], [3, 4]])) == pf.eval("[[1, 2], [3, 4]]")
    curve = pf.bezier(numpy.array([[0, 0], [1, 2], [2, 0]]))
    assert curve(Fraction(1, 2)).numpy(dtype=float).tolist() == [1.0, 1.0]
    for bad in [numpy.array([0.5, 1.0]), numpy.float64(0.5), numpy.float32(0.5)]:
        with pytest.raises(TypeError):
            pf.Value(bad)

#!/usr/bin/env python3
"""Random queries, answered by polarform and by other systems: FLINT, PARI, SciPy, and plain fractions in Python.

    python3 -m venv venv && venv/bin/pip install python-flint cypari scipy
    venv/bin/python tests/differential.py --cases 200000 [--seed 1] [--only gcd] [--program target/release/polarform]

Optional: no part of `cargo test`. The cases depend on the seed alone. Queries go to `polarform run -` in batches, and
its answers come back in the syntax of SymPy, which is evaluated over FLINT. `--keep FILE` writes some cases of each
kind as lines `query ==> answer of the peer`, which tests/differential.rs reads.
"""
import argparse, ast, collections, random, re, subprocess, sys, time, types
from fractions import Fraction
from math import comb, factorial, gcd, lcm

import cypari
import flint
from flint import fmpq, fmpq_mat, fmpq_mpoly_ctx, fmpq_poly, fmpz, fmpz_mpoly_ctx, fmpz_poly
from scipy import interpolate as scipy_interpolate

pari = cypari.pari
sys.setrecursionlimit(100_000)
NAMES = ("t", "u", "x", "y", "z")
RING = fmpq_mpoly_ctx.get(NAMES, "lex")
GENERATORS = dict(zip(NAMES, RING.gens()))

# ---- what polarform writes, as values -----------------------------------------------------------------------------


# Integers are exact numbers, so that 1/2 is no float; exponents stay integers.
INTEGER = re.compile(r"(?<![\w])(?<!\*\*)(\d+)")
SCOPE = {
    "Rational": lambda p, q: p / q,
    "Matrix": lambda rows: rows,
    "Eq": lambda name, value: value,
    "Z": fmpq,
    "__builtins__": {},
    **GENERATORS,
}


def value_of(text):
    """What stands in an answer: numbers as fmpq, polynomials over Q, lists; a matrix is a list of rows."""
    return plain(eval(INTEGER.sub(r"Z(\1)", text.replace(" ** ", "**")), SCOPE))


def plain(value):
    """Constants are numbers, whatever they were written as."""
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, (int, fmpz)):
        return fmpq(value)
    if isinstance(value, Fraction):
        return fmpq(value.numerator, value.denominator)
    if isinstance(value, flint.fmpq_mpoly) and value.is_constant():
        terms = list(value.coeffs())
        return terms[0] if terms else fmpq(0)
    return value


# ---- random things --------------------------------------------------------------------------------------------------


class Draw(random.Random):
    def number(self, size=None):
        size = size or self.choice([3, 10, 10, 1000, 10**9, 10**25])
        p = self.randint(-size, size)
        return Fraction(p, self.randint(1, min(size, 50)) if self.random() < 0.5 else 1)

    def natural(self, size=None):
        size = size or self.choice([3, 10, 100, 10**6, 10**20, 10**60])
        return self.randint(0, size)

    def coefficients(self, degree, size=None):
        """Of a polynomial in one variable, the constant first."""
        size = size or self.choice([3, 10, 1000, 10**15])
        found = [self.number(size) if self.random() < 0.8 else Fraction(0) for _ in range(degree + 1)]
        return found

    def integers(self, degree, size=None):
        return [c.numerator for c in self.coefficients(degree, size)]

    def terms(self, names, count, degree, size=None):
        """Of a polynomial in several variables: {exponents: integer}."""
        size = size or self.choice([3, 20, 1000, 10**12])
        found = {}
        for _ in range(count):
            e = tuple(self.randint(0, degree) for _ in names)
            found[e] = self.randint(-size, size) or 1
        return found

    def increasing(self, count, size=30):
        """Different numbers in their order."""
        found = set()
        while len(found) < count:
            found.add(Fraction(self.randint(-size, size), self.choice([1, 1, 1, 2, 3, 7])))
        return sorted(found)

    def knots(self, degree, count):
        """count + degree + 1 knots: the ends as often as a domain wants, inner ones up to degree + 1 times."""
        inner = []
        distinct = iter(self.increasing(count + 2 * degree + 4))
        start = next(distinct)
        knots = [start] * (degree + 1) if self.random() < 0.7 else [start]
        while len(knots) < count + degree + 1:
            knots += [next(distinct)] * self.choice([1, 1, 1, 1, 2, degree, degree + 1] if degree else [1])
        knots = knots[: count + degree + 1]
        return knots


def written(q):
    return str(q.numerator) if q.denominator == 1 else f"{q.numerator}/{q.denominator}"


def in_list(numbers):
    return "[" + ", ".join(map(written, numbers)) + "]"


def polynomial(coefficients, name="t"):
    """A polynomial in one variable, as it is typed."""
    parts = [f"({written(c)}) {name}^{k}" for k, c in enumerate(coefficients) if c]
    return " + ".join(reversed(parts)) or "0"


def formula(terms, names):
    def monomial(e):
        return " ".join(f"{name}^{k}" for name, k in zip(names, e) if k)

    return " + ".join(f"({c}) {monomial(e)}" for e, c in terms.items()) or "0"


def mpoly(terms, names):
    """The same for FLINT."""
    places = [NAMES.index(name) for name in names]
    whole = {}
    for e, c in terms.items():
        key = [0] * len(NAMES)
        for place, k in zip(places, e):
            key[place] = k
        whole[tuple(key)] = fmpq(c)
    return RING.from_dict(whole)


def q(x):
    x = Fraction(x)
    return fmpq(x.numerator, x.denominator)


def upoly(coefficients):
    return fmpq_poly([q(c) for c in coefficients])


def lifted(p, name="t"):
    """A polynomial in one variable as one in several."""
    x = GENERATORS[name]
    total = 0 * x
    for c in reversed(p.coeffs()):
        total = total * x + c
    return total


def integral(p):
    """The coefficients of p times the least common denominator."""
    return fmpz_poly([int(c) for c in (p * p.denom()).coeffs()])


# ---- cases: (query, what a peer says) -------------------------------------------------------------------------------
# Each draws one case. The answer is compared as a value; a function as second item decides itself.

KINDS = {}


def kind(weight=1):
    def keep(make):
        KINDS[make.__name__] = (make, weight)
        return make

    return keep


@kind(2)
def product(r):
    names = r.sample(NAMES, r.randint(1, 4))
    a, b = (r.terms(names, r.randint(0, 12), r.choice([1, 3, 9])) for _ in "ab")
    return f"({formula(a, names)}) ({formula(b, names)})", mpoly(a, names) * mpoly(b, names)


@kind()
def power(r):
    names = r.sample(NAMES, r.randint(1, 3))
    a, k = r.terms(names, r.randint(1, 5), 3), r.randint(0, 7)
    return f"({formula(a, names)})^{k}", mpoly(a, names) ** k


@kind(2)
def product_in_t(r):
    a, b = (r.coefficients(r.choice([0, 1, 5, 30, 60])) for _ in "ab")
    return f"({polynomial(a)}) ({polynomial(b)})", lifted(upoly(a) * upoly(b))


@kind(3)
def gcd_in_several(r):
    names = r.sample(NAMES, r.randint(2, 4))
    a, b, c = (r.terms(names, r.randint(1, 6), r.choice([1, 2, 4])) for _ in "abc")
    f, g = mpoly(a, names) * mpoly(c, names), mpoly(b, names) * mpoly(c, names)

    def right(value):
        # Up to the sign; with the greatest common divisor of all coefficients.
        ring = fmpz_mpoly_ctx.get(NAMES, "lex")
        over = [ring.from_dict({e: fmpz(v.p) for e, v in p.to_dict().items()}) for p in (f, g)]
        found = over[0].gcd(over[1])
        mine = {e: v for e, v in as_mpoly(value).to_dict().items()}
        theirs = {e: fmpq(v) for e, v in found.to_dict().items()}
        return mine == theirs or mine == {e: -v for e, v in theirs.items()}

    products = [f"({formula(p, names)}) ({formula(c, names)})" for p in (a, b)]
    return f"gcd({products[0]}, {products[1]})", right


def as_mpoly(value):
    return value if isinstance(value, flint.fmpq_mpoly) else value + 0 * GENERATORS["t"]


@kind(2)
def gcd_in_t(r):
    a, b, c = (r.integers(r.choice([0, 1, 4, 12, 25]), r.choice([3, 100, 10**12])) for _ in "abc")
    f, g = fmpz_poly(a) * fmpz_poly(c), fmpz_poly(b) * fmpz_poly(c)
    found = lifted(fmpq_poly(f.gcd(g)))
    products = [f"({polynomial(list(map(Fraction, p)))}) ({polynomial(list(map(Fraction, c)))})" for p in (a, b)]
    return f"gcd({products[0]}, {products[1]})", lambda value: value in (plain(found), plain(-found))


@kind(2)
def division(r):
    a = r.coefficients(r.randint(0, 20))
    b = r.coefficients(r.randint(0, 10))
    if not any(b):
        b = [Fraction(1)]
    f, g = upoly(a), upoly(b)
    which = r.choice(["quotient", "remainder"])
    found = f // g if which == "quotient" else f % g
    return f"{which}({polynomial(a)}, {polynomial(b)}, t)", lifted(found)


@kind()
def exact_division(r):
    names = r.sample(NAMES, r.randint(1, 4))
    a, b = (r.terms(names, r.randint(1, 8), r.choice([1, 3, 6])) for _ in "ab")
    f = mpoly(a, names) * mpoly(b, names)
    return f"(({formula(a, names)}) ({formula(b, names)}))/({formula(b, names)})", f / mpoly(b, names)


@kind(2)
def fractions(r):
    names = r.sample(NAMES, r.randint(1, 3))
    a, b, c, d = (r.terms(names, r.randint(1, 4), r.choice([1, 2]), r.choice([3, 20])) for _ in "abcd")
    which, sign = r.choice(["numerator", "denominator"]), r.choice("+-")
    f, g, h, k = (mpoly(p, names) for p in (a, b, c, d))
    top, bottom = (f * k + h * g if sign == "+" else f * k - h * g), g * k

    def right(value):
        if top == 0:
            return value == (0 if which == "numerator" else 1)
        common = top.gcd(bottom)
        wanted = (top if which == "numerator" else bottom) / common
        return as_mpoly(value) * wanted.leading_coefficient() == wanted * as_mpoly(value).leading_coefficient()

    text = f"({formula(a, names)})/({formula(b, names)}) {sign} ({formula(c, names)})/({formula(d, names)})"
    return f"{which}({text})", right


@kind(2)
def resultant(r):
    a, b = (r.integers(r.randint(1, 9), r.choice([3, 50, 10**8])) for _ in "ab")
    a[-1], b[-1] = a[-1] or 1, b[-1] or 1
    value = pari.polresultant(pari.Polrev(a, "t"), pari.Polrev(b, "t"))
    texts = [polynomial(list(map(Fraction, p))) for p in (a, b)]
    return f"resultant({texts[0]}, {texts[1]}, t)", fmpq(int(value))


@kind()
def discriminant(r):
    a = r.integers(r.randint(1, 9), r.choice([3, 50, 10**8]))
    a[-1] = a[-1] or 1
    return f"discriminant({polynomial(list(map(Fraction, a)))}, t)", fmpq(int(pari.poldisc(pari.Polrev(a, "t"))))


@kind()
def resultant_in_two(r):
    a, b = (r.terms(["x", "y"], r.randint(1, 5), 3, 9) for _ in "ab")
    f, g = (pari("+".join(f"({c})*x^{i}*y^{j}" for (i, j), c in p.items())) for p in (a, b))
    found = pari.polresultant(f, g, "x")
    if pari.poldegree(f, "x") < 1 or pari.poldegree(g, "x") < 1:
        return None
    return (
        f"resultant({formula(a, ['x', 'y'])}, {formula(b, ['x', 'y'])}, x)",
        value_of(str(found).replace("^", "**")),
    )


@kind(2)
def factor(r):
    parts = [r.integers(r.randint(1, 4), r.choice([3, 20])) for _ in range(r.randint(1, 4))]
    whole = fmpz_poly([1])
    for part in parts:
        part[-1] = part[-1] or 1
        whole *= fmpz_poly(part) ** r.choice([1, 1, 1, 2])
    if whole.degree() < 1:
        return None
    content, factors = whole.factor()
    theirs = collections.Counter()
    for p, k in factors:
        theirs[tuple(map(int, p.coeffs()))] += k

    def right(value, text):
        mine, constant = collections.Counter(), fmpq(1)
        for p, k in factors_of(text):
            p = as_mpoly(p)
            if p.is_constant():
                constant *= plain(p) ** k
                continue
            coefficients = [int(c) for c in dense(p)]
            if coefficients[-1] < 0:
                coefficients, constant = [-c for c in coefficients], constant * (-1) ** k
            mine[tuple(coefficients)] += k
        return mine == theirs and constant == int(content)

    return f"factor({polynomial(list(map(Fraction, map(int, whole.coeffs()))))})", right


def dense(p):
    """The coefficients of a polynomial that has only t in it."""
    found = {e[0]: c for e, c in p.to_dict().items()}
    return [found.get(k, fmpq(0)) for k in range(max(found, default=0) + 1)]


def factors_of(text):
    """The factors that stand in an answer, with their exponents."""
    found = []

    def walk(node, power, sign=1):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
            walk(node.left, power)
            walk(node.right, power)
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            walk(node.left, power * node.right.value)
        elif isinstance(node, ast.UnaryOp):
            found.append((fmpq(-1), power))
            walk(node.operand, power)
        else:
            found.append((value_of(ast.unparse(node)), power))

    walk(ast.parse(text, mode="eval").body, 1)
    return found


@kind()
def factor_number(r):
    n = 1
    for _ in range(r.randint(1, 6)):
        n *= r.randint(2, r.choice([10, 1000, 10**6, 10**9]))
    theirs = {int(p): k for p, k in fmpz(n).factor()}

    def right(value, text):
        mine = collections.Counter()
        for p, k in factors_of(text):
            mine[int(p.p)] += k
        return mine == theirs

    return f"factor({n})", right


@kind()
def numbers(r):
    a, b = r.natural(), r.natural()
    which = r.choice(["gcd", "lcm", "binomial", "factorial", "value"])
    if which == "binomial":
        n = r.randint(0, 400)
        k = r.randint(0, n + 3)
        return f"binomial({n}, {k})", fmpq(comb(n, k))
    if which == "factorial":
        n = r.randint(0, 300)
        return f"{n}!", fmpq(factorial(n))
    if which == "gcd":
        return f"gcd({a}, {b})", fmpq(gcd(a, b))
    if which == "lcm":
        return f"lcm({a}, {b})", fmpq(lcm(a, b))
    p, s, u = r.number(), r.number(), r.number()
    if u == 0:
        return None
    k = r.randint(0, 6)
    return f"(({written(p)}) - ({written(s)}))^{k}/({written(u)})", q((p - s) ** k / u)


@kind()
def sums(r):
    c, a = r.coefficients(r.randint(0, 4), 20), r.randint(-3, 5)
    b = a + r.randint(-1, 25)
    total = sum((sum(ck * Fraction(i) ** k for k, ck in enumerate(c)) for i in range(a, b + 1)), Fraction(0))
    return f"sum(i={a}..{b}, {polynomial(c, 'i')})", q(total)


@kind()
def calculus(r):
    a, b = r.coefficients(r.randint(0, 8)), r.coefficients(r.randint(0, 4), 10)
    f, g, s = upoly(a), upoly(b), r.number(10)
    which = r.choice(["diff", "integrate", "area", "compose", "value"])
    if which == "diff":
        k = r.randint(0, 9)
        for _ in range(k):
            f = f.derivative()
        return f"diff({polynomial(a)}, t, {k})", lifted(f)
    if which == "integrate":
        return f"integrate({polynomial(a)}, t)", lifted(f.integral())
    if which == "area":
        e, p = r.number(10), f.integral()
        return f"integrate({polynomial(a)}, t, {written(s)}, {written(e)})", p(q(e)) - p(q(s))
    if which == "compose":
        return f"subs({polynomial(a)}, t, {polynomial(b)})", lifted(f(g))
    return f"subs({polynomial(a)}, t, {written(s)})", f(q(s))


@kind()
def partial_derivatives(r):
    names = r.sample(NAMES, r.randint(2, 4))
    a, by, k = r.terms(names, r.randint(1, 8), 4), r.choice(names), r.randint(0, 3)
    f = mpoly(a, names)
    for _ in range(k):
        f = f.derivative(by)
    return f"diff({formula(a, names)}, {by}, {k})", f


@kind()
def substitution(r):
    names = r.sample(NAMES, r.randint(2, 3))
    a = r.terms(names, r.randint(1, 5), 3, 10)
    b = r.terms(names, r.randint(1, 3), 2, 10)
    f, g = mpoly(a, names), mpoly(b, names)
    found = f.compose(*[g if name == names[0] else GENERATORS[name] for name in NAMES])
    return f"subs({formula(a, names)}, {names[0]}, {formula(b, names)})", found


def rows(matrix):
    return "[" + "; ".join(", ".join(map(written, row)) for row in matrix) + "]"


def square(r, n):
    size = r.choice([2, 10, 1000, 10**12])
    matrix = [[r.number(size) for _ in range(n)] for _ in range(n)]
    if n > 1 and r.random() < 0.2:
        matrix[-1] = [2 * a - b for a, b in zip(matrix[0], matrix[n // 2])]
    return matrix


def matrix_of(m):
    return fmpq_mat(len(m), len(m[0]), [q(a) for row in m for a in row])


@kind(2)
def matrices(r):
    n = r.randint(2, 8)
    m = square(r, n)
    a = matrix_of(m)
    which = r.choice(["det", "inverse", "rank", "solve", "charpoly", "product"])
    if which == "det":
        return f"det({rows(m)})", a.det()
    if which == "rank":
        return f"rank({rows(m)})", fmpq(a.rank())
    if which == "product":
        b = square(r, n)
        return f"{rows(m)} {rows(b)}", (a * matrix_of(b)).tolist()
    if which == "charpoly":
        if n > 5:
            return None
        return f"characteristic_polynomial({rows(m)}, variable=t)", lifted(a.charpoly())
    if a.det() == 0:
        return None
    if which == "inverse":
        return f"({rows(m)})^-1", a.inv().tolist()
    b = [r.number(100) for _ in range(n)]
    found = a.solve(fmpq_mat(n, 1, [q(x) for x in b]))
    return f"solve({rows(m)}, {in_list(b)})", lambda value: flat(value) == [row[0] for row in found.tolist()]


def flat(value):
    return [x for item in value for x in (flat(item) if isinstance(item, list) else [item])]


@kind(2)
def interpolation(r):
    n = r.randint(1, 9)
    x, y = r.increasing(n), [r.number(r.choice([10, 10**6])) for _ in range(n)]
    r.shuffle(x)
    v = fmpq_mat(n, n, [q(a) ** k for a in x for k in range(n)])
    c = v.solve(fmpq_mat(n, 1, [q(a) for a in y]))
    found = fmpq_poly([row[0] for row in c.tolist()])
    which = r.choice(["lagrange", "newton", "value", "neville"])
    if which == "lagrange":
        return f"subs(lagrange({in_list(x)}, {in_list(y)})(t), t, t)", lifted(found)
    if which == "newton":
        return f"subs(newton({in_list(x)}, {in_list(y)})(t), t, t)", lifted(found)
    at = r.number(20)
    if which == "value":
        return f"lagrange({in_list(x)}, {in_list(y)})({written(at)})", found(q(at))
    return f"hermite([{', '.join(in_list([a, b]) for a, b in zip(x, y))}])({written(at)})", found(q(at))


@kind(2)
def polar(r):
    """By the definition with elementary symmetric functions."""
    n = r.randint(1, 9)
    c = r.coefficients(r.randint(0, n))
    arguments = [r.number(r.choice([3, 100])) for _ in range(n)]
    e = [Fraction(1)] + [Fraction(0)] * n
    for u in arguments:
        for k in range(n, 0, -1):
            e[k] += u * e[k - 1]
    total = sum((ck * e[k] / comb(n, k) for k, ck in enumerate(c)), Fraction(0))
    return f"polar({polynomial(c)}, degree={n}, variable=t)({', '.join(map(written, arguments))})", q(total)


def bernstein_value(b, s):
    n = len(b) - 1
    return sum((comb(n, i) * s**i * (1 - s) ** (n - i) * x for i, x in enumerate(b)), Fraction(0))


@kind(2)
def bezier(r):
    b = [r.number(r.choice([10, 10**5])) for _ in range(r.randint(1, 12))]
    a, e = r.increasing(2)
    t = r.choice([a, e, a + (e - a) * Fraction(r.randint(0, 20), 20)])
    which = r.choice(["value", "powers", "elevate", "part"])
    curve = f"bezier({in_list(b)}, {written(a)}, {written(e)})"
    if which == "value":
        return f"({curve})({written(t)})", q(bernstein_value(b, (t - a) / (e - a)))
    s = fmpq_poly([q(-a / (e - a)), q(1 / (e - a))])
    n = len(b) - 1
    p = sum((comb(n, i) * q(x) * s**i * (1 - s) ** (n - i) for i, x in enumerate(b)), fmpq_poly([0]))
    if which == "powers":
        return f"extended({curve}, t)", lifted(p)
    if which == "elevate":
        k = r.randint(1, 4)
        found = [sum((Fraction(comb(n, j) * comb(k, i - j), comb(n + k, i)) * b[j] for j in range(max(0, i - k), min(n, i) + 1)), Fraction(0)) for i in range(n + k + 1)]
        return f"control_points(elevate({curve}, {k}))", [q(x) for x in found]
    if n == 0:
        return None
    u, v = sorted(r.sample([a + (e - a) * Fraction(k, 12) for k in range(13)], 2))
    line = fmpq_poly([q(u), q(v - u)])
    c = p(line).coeffs() + [fmpq(0)] * (n + 1)
    found = [sum((fmpq(comb(i, j), comb(n, j)) * c[j] for j in range(i + 1)), fmpq(0)) for i in range(n + 1)]
    return f"control_points(part({curve}, {written(u)}, {written(v)}))", found


def close(value, wanted, scale=1.0):
    def number(x):
        return int(x.p) / int(x.q) if isinstance(x, fmpq) else float(x)

    a, b = flat([value]), flat([list(wanted) if hasattr(wanted, "__iter__") else wanted])
    return len(a) == len(b) and all(abs(number(x) - y) <= 1e-7 * max(scale, abs(y)) for x, y in zip(a, b))


@kind(2)
def bspline(r):
    """Against SciPy, with floating point; the pieces of a basis function at random places."""
    n = r.randint(0, 5)
    m = r.randint(n + 1, n + 7)
    knots = r.knots(n, m)
    a, b = knots[n], knots[m]
    if a == b:
        return None
    d = [Fraction(r.randint(-20, 20), r.choice([1, 2, 3])) for _ in range(m)]
    t = a + (b - a) * Fraction(r.randint(0, 60), 61)
    theirs = scipy_interpolate.BSpline([float(x) for x in knots], [float(x) for x in d], n)
    which = r.choice(["value", "derivative", "basis", "insert"])
    spline = f"bspline({n}, {in_list(knots)}, {in_list(d)})"
    if which == "value":
        wanted = float(theirs(float(t)))
        return f"({spline})({written(t)})", lambda value: close(value, wanted, 20)
    if which == "basis":
        i = r.randrange(m)
        one = scipy_interpolate.BSpline([float(x) for x in knots], [float(j == i) for j in range(m)], n)
        wanted = float(one(float(t)))
        return f"bspline_basis({n}, {in_list(knots)}, {i})({written(t)})", lambda value: close(value, wanted)
    if which == "derivative":
        if n == 0:
            return None
        k = r.randint(1, n)
        wanted = float(theirs(float(t), nu=k))
        at = f"derivatives_at({spline}, {written(t)}, {k})"
        size = 40.0 * (2 * n / float(min(y - x for x, y in zip(knots, knots[1:]) if x != y))) ** k
        return at, lambda value: close(flat(value)[-1], wanted, size)
    if n == 0 or knots.count(t) >= n or not a < t < b:
        return None
    # By the definition: F has the control points f(t_{i+1}, …, t_{i+n}), here by Boehm's ratios in fractions.
    j = max(i for i, x in enumerate(knots) if x <= t)
    found = []
    for i in range(m + 1):
        if i <= j - n:
            found.append(d[i])
        elif i > j:
            found.append(d[i - 1])
        else:
            ratio = (t - knots[i]) / (knots[i + n] - knots[i])
            found.append((1 - ratio) * d[i - 1] + ratio * d[i])
    return f"control_points(insert_knots({spline}, {written(t)}))", [q(x) for x in found]


@kind()
def cubic_spline(r):
    x = r.increasing(r.randint(4, 9))
    y = [r.number(20) for _ in x]
    ends = r.choice(["natural", "not_a_knot", "clamped"])
    slopes = [r.number(5), r.number(5)]
    bc = {"natural": "natural", "not_a_knot": "not-a-knot", "clamped": ((1, float(slopes[0])), (1, float(slopes[1])))}
    theirs = scipy_interpolate.CubicSpline([float(a) for a in x], [float(a) for a in y], bc_type=bc[ends])
    t = x[0] + (x[-1] - x[0]) * Fraction(r.randint(0, 30), 30)
    wanted = float(theirs(float(t)))
    extra = f", slopes={in_list(slopes)}" if ends == "clamped" else ""
    size = max(1.0, *(abs(float(a)) for a in y))
    gaps = min(float(b - a) for a, b in zip(x, x[1:]))
    scale = size * (1 + (float(x[-1] - x[0]) / gaps) ** 3)
    return (
        f"cubic_spline({in_list(x)}, {in_list(y)}, ends={ends}{extra})({written(t)})",
        lambda value: close(value, wanted, scale * 1e-3),
    )


@kind(2)
def counting_roots(r):
    parts = [r.integers(r.randint(1, 3), 9) for _ in range(r.randint(1, 3))]
    whole = fmpz_poly([1])
    for part in parts:
        part[-1] = part[-1] or 1
        whole *= fmpz_poly(part) ** r.choice([1, 1, 2])
    if whole.degree() < 1:
        return None
    a, b = sorted(r.sample(range(-12, 13), 2))
    c = list(map(int, whole.coeffs()))
    p = pari.Polrev(c, "t")
    free = p / pari.gcd(p, pari.deriv(p))
    inside = int(pari.polsturm(free, f"[{a},{b}]"))  # in the closed interval
    if int(pari.subst(p, "t", a)) == 0:
        inside -= 1
    text = polynomial(list(map(Fraction, c)))
    return f"count_roots({text}, {a}, {b})", fmpq(inside)


@kind()
def roots(r):
    parts = [r.integers(r.randint(1, 3), 9) for _ in range(r.randint(1, 3))]
    whole = fmpz_poly([1])
    for part in parts:
        part[-1] = part[-1] or 1
        whole *= fmpz_poly(part)
    if whole.degree() < 1:
        return None
    c = list(map(int, whole.coeffs()))
    theirs = []
    for p, k in whole.factor()[1]:
        found = pari.polrootsreal(pari.Polrev(list(map(int, p.coeffs())), "t"))
        theirs += [float(x) for x in found for _ in range(k)]
    theirs.sort()

    def right(value, text):
        mine = [bounds(node) for node in ast.parse(text, mode="eval").body.elts]
        return len(mine) == len(theirs) and all(
            low - 1e-9 <= x <= high + 1e-9 for (low, high), x in zip(mine, theirs)
        )

    return f"roots({polynomial(list(map(Fraction, c)))})", right


def bounds(node):
    """Between which numbers a root lies."""
    if isinstance(node, ast.Call) and node.func.id == "root_of":
        ends = [value_of(ast.unparse(item)) for item in node.args[1:3]]
    else:
        ends = [value_of(ast.unparse(node))] * 2
    return tuple(int(x.p) / int(x.q) for x in ends)


@kind()
def legendre(r):
    n = r.randint(0, 25)
    return f"legendre({n}, t, -1, 1)", lifted(fmpq_poly.legendre_p(n))


@kind()
def bases(r):
    n = r.randint(0, 10)
    which = r.choice(["to_power", "to_bernstein", "bernstein"])
    if which == "to_power":
        found = [[fmpq((-1) ** (i - j) * comb(n, i) * comb(i, j)) if j <= i else fmpq(0) for j in range(n + 1)] for i in range(n + 1)]
        return f"bernstein_to_power({n})", found
    if which == "to_bernstein":
        found = [[fmpq(comb(i, j), comb(n, j)) for j in range(n + 1)] for i in range(n + 1)]
        return f"power_to_bernstein({n})", found
    i, t = r.randint(-1, n + 1), r.number(10)
    value = comb(n, i) * t**i * (1 - t) ** (n - i) if 0 <= i <= n else Fraction(0)
    return f"bernstein({n}, {i}, {written(t)})", q(value)


# ---- running --------------------------------------------------------------------------------------------------------


def answers(program, queries):
    """The answer to each query, or its error."""
    ran = subprocess.run(
        [program, "--format", "sympy", "--timeout", "20", "--color", "never", "run", "-"],
        input="\n".join(queries),
        capture_output=True,
        text=True,
    )
    wrong = {}
    for line in ran.stderr.splitlines():
        if line.startswith(("error", "note", "warning")):
            message = line
        elif line.lstrip().startswith("--> <stdin>:") and message.startswith("error"):
            wrong.setdefault(int(line.split(":")[1]), message)
    lines = iter(ran.stdout.splitlines())
    found = []
    for number in range(1, len(queries) + 1):
        found.append(wrong[number] if number in wrong else next(lines, "error: no answer"))
    if next(lines, None) is not None:
        sys.exit("the program answers more than was asked")
    return found


def agrees(text, expected):
    if text.startswith("error"):
        return False
    if isinstance(expected, types.FunctionType):
        if expected.__code__.co_argcount == 2:
            return expected(None, text)
        return expected(value_of(text))
    return value_of(text) == plain(expected)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=sorted(KINDS))
    parser.add_argument("--program", default="target/release/polarform")
    parser.add_argument("--keep", help="a file for a few cases of each kind")
    options = parser.parse_args()
    r = Draw(options.seed)
    names = [options.only] if options.only else [name for name, (_, weight) in KINDS.items() for _ in range(weight)]
    counts, failures, kept = collections.Counter(), 0, collections.defaultdict(list)
    begun = time.time()
    while sum(counts.values()) < options.cases:
        batch = []
        while len(batch) < min(2000, options.cases - sum(counts.values())):
            name = r.choice(names)
            case = KINDS[name][0](r)
            if case is not None:
                batch.append((name, *case))
        for (name, query, expected), text in zip(batch, answers(options.program, [b[1] for b in batch])):
            counts[name] += 1
            try:
                right = agrees(text, expected)
            except Exception as error:
                right, text = False, f"{text}   ({type(error).__name__}: {error})"
            if not right:
                failures += 1
                print(f"DIFFERS, {name}: {query}\n  polarform: {text}", flush=True)
                if not isinstance(expected, types.FunctionType):
                    print(f"  peer:      {plain(expected)}", flush=True)
            elif len(query) + len(text) < 300 and r.random() < 0.05:
                kept[name].append((query, text))
        print(f"{sum(counts.values())} cases, {failures} differ, {time.time() - begun:.0f} s", flush=True)
    print(dict(sorted(counts.items())))
    if options.keep:
        with open(options.keep, "w") as out:
            out.write("# Cases of tests/differential.py on which other systems agree, with the answer in the syntax of SymPy.\n")
            for name in sorted(kept):
                out.write(f"# {name}\n")
                for query, text in sorted(set(kept[name][:12]), key=lambda case: len(case[0])):
                    out.write(f"{query} ==> {text}\n")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()

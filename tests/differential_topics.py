#!/usr/bin/env python3
"""Random queries about blossoms, roots, positivity, subdivision, intersections and curvature, against definitions in plain fractions.

    python3 -m venv venv && venv/bin/pip install python-flint cypari scipy
    venv/bin/python tests/differential_topics.py --each 500 [--seed 1] [--only qblossom] [--program target/release/polarform]

As differential_geometry.py, which has the tools. `vertex` has fewer different cases: four schemes, valences up to 24.
"""
import re
from fractions import Fraction
from math import comb, cos, factorial, hypot, isclose, pi

import cypari
import numpy
from flint import fmpq, fmpq_mat, fmpq_poly
from scipy.integrate import quad

import differential as base
import differential_geometry as geometry
from differential import in_list, polynomial, q, rows, value_of, written
from differential_geometry import (
    Lines, bezier_of, casteljau, control_points, cox, cross, dot, elementary, integers, jet_of, mixed, net_of, numbers, points_of, power_form,
    powers, same, slope, small, solved, some_points, times, triangle, two, value, value_in_two,
)

pari = cypari.pari
KINDS = {}


def kind(build):
    KINDS[build.__name__] = build
    return build


def of(p):
    return f"{polynomial(p)} + 0 t"


def fitted(f, degree):
    """The coefficients of a polynomial by its values."""
    places = [Fraction(k) for k in range(degree + 1)]
    return solved([[x**k for k in range(degree + 1)] for x in places], [f(x) for x in places])


def fraction(x):
    return Fraction(int(x.p), int(x.q))


# ---- polar forms ----------------------------------------------------------------------------------------------------


@kind
def partial(r):
    n = r.randint(1, 6)
    c, u = numbers(r, n + 1), numbers(r, n)
    k = r.randint(0, n - 1)
    first = ", ".join(map(written, u[:k]))
    rest = ", ".join(map(written, u[k:]))
    f = f"polar({of(c)}, degree={n}, variable=t)"
    query = f"(g -> g({rest}))(partial({f}, {first}))" if k else f"{f}({rest})"
    return query, q(power_form(c, u))


@kind
def elevate_and_diagonal(r):
    n, k = r.randint(1, 5), r.randint(0, 3)
    c, u = numbers(r, n + 1), numbers(r, n + k)
    f = f"elevate(polar({of(c)}, degree={n}, variable=t), {k})"
    if r.random() < 0.5:
        return f"{f}({', '.join(map(written, u))})", q(power_form(c, u))
    return f"diagonal(reduce({f}, {k}))", base.lifted(base.upoly(c))


@kind
def polar_of_products(r):
    a, b = numbers(r, r.randint(1, 4)), numbers(r, r.randint(1, 3))
    a[-1], b[-1] = a[-1] or Fraction(1), b[-1] or Fraction(1)
    which = r.choice(["polar_product", "polar_compose", "polar_sum"])
    if which == "polar_product":
        whole = times(a, b)
    elif which == "polar_sum":
        whole = geometry.plus(a, b)
        whole = whole[: max(len(a), len(b))]
    else:
        whole = [Fraction(0)]
        for c in reversed(a):
            whole = geometry.plus(times(whole, b), [c])
        whole = whole[: (len(a) - 1) * (len(b) - 1) + 1]
    n = len(whole) - 1
    if n == 0:
        return None
    u = numbers(r, n)
    method = ", method=symmetrize" if which != "polar_sum" and r.random() < 0.5 and n < 7 else ""
    return f"{which}({of(a)}, {of(b)}{method})({', '.join(map(written, u))})", q(power_form(whole, u))


@kind
def bezier_points(r):
    n = r.randint(0, 6)
    c = numbers(r, n + 1)
    c[-1] = c[-1] or Fraction(1)
    a = small(r)
    b = a + r.choice([-1, 1]) * (abs(small(r)) + 1)
    points = control_points(c, n, a, b)
    if r.random() < 0.5 or n == 0:
        return f"bezier_points({of(c)}, {written(a)}, {written(b)})", same(points)
    u = numbers(r, n)
    return f"from_bezier({in_list(points)}, {written(a)}, {written(b)})({', '.join(map(written, u))})", q(power_form(c, u))


@kind
def qblossom(r):
    n, factor = r.randint(1, 5), r.choice([Fraction(2), Fraction(3), Fraction(1, 2), Fraction(-3), Fraction(1), Fraction(2, 5)])
    c, u = numbers(r, n + 1), numbers(r, n)
    rule = [factor**k for k in range(n)]
    wanted = sum(c[k] / elementary(rule, k) * elementary(u, k) for k in range(n + 1))
    return f"qblossom({of(c)}, {written(factor)}, degree={n}, variable=t)({', '.join(map(written, u))})", q(wanted)


@kind
def hblossom(r):
    n, h = r.randint(1, 5), small(r)
    c, u = numbers(r, n + 1), numbers(r, n)
    places = [Fraction(k) for k in range(n + 1)]
    found = solved(
        [[elementary([t - i * h for i in range(n)], k) for k in range(n + 1)] for t in places], [value(c, t) for t in places]
    )
    wanted = sum(a * elementary(u, k) for k, a in enumerate(found))
    return f"hblossom({of(c)}, {written(h)}, degree={n}, variable=t)({', '.join(map(written, u))})", q(wanted)


@kind
def mobius(r):
    n = r.randint(1, 5)
    coefficients, u = numbers(r, n + 1), numbers(r, n)
    a, b, c, d = numbers(r, 4, 3)
    whole = fitted(
        lambda t: sum((x * (a * t + b) ** k * (c * t + d) ** (n - k) for k, x in enumerate(coefficients)), Fraction(0)), n
    )
    shown = ", ".join(map(written, (a, b, c, d)))
    if a * d == b * c:
        return None
    return f"mobius({of(coefficients)}, {shown}, degree={n}, variable=t)({', '.join(map(written, u))})", q(power_form(whole, u))


@kind
def apolar(r):
    n = r.randint(1, 5)
    c, roots, lead = numbers(r, n + 1), numbers(r, n), small(r) or Fraction(2)
    other = [lead]
    for x in roots:
        other = times(other, [-x, Fraction(1)])
    return f"apolar({of(c)}, {of(other)}, degree={n}, variable=t)", q(lead * power_form(c, roots))


@kind
def symmetric_functions(r):
    n = r.randint(1, 6)
    i, u = r.randint(0, n), numbers(r, n)
    if r.random() < 0.5:
        return f"sigma({i}, {n}, {', '.join(map(written, u))})", q(elementary(u, i) / comb(n, i))
    return f"esym({i}, {', '.join(map(written, u))})", q(elementary(u, i))


def tetrahedron(r):
    while True:
        p = some_points(r, 4, 3, 3)
        edges = [[q(x - y) for x, y in zip(a, p[0])] for a in p[1:]]
        if fmpq_mat(edges).det() != 0:
            return p


def indices_in_space(d):
    return [(i, j, k, d - i - j - k) for i in range(d, -1, -1) for j in range(d - i, -1, -1) for k in range(d - i - j, -1, -1)]


def bernstein_in_space(d, coefficients, shares):
    total = Fraction(0)
    for (i, j, k, l), c in zip(indices_in_space(d), coefficients):
        weight = factorial(d) // (factorial(i) * factorial(j) * factorial(k) * factorial(l))
        total += c * weight * shares[0] ** i * shares[1] ** j * shares[2] ** k * shares[3] ** l
    return total


def shares_of(r, count):
    parts = [Fraction(r.randint(-2, 5)) for _ in range(count)]
    return [x / sum(parts) for x in parts] if sum(parts) else [Fraction(1, count)] * count


@kind
def from_tetrahedral(r):
    d, corners = r.randint(1, 3), tetrahedron(r)
    b = numbers(r, len(indices_in_space(d)))
    shares = shares_of(r, 4)
    p = [sum(s * c[k] for s, c in zip(shares, corners)) for k in range(3)]
    made = f"from_tetrahedral({in_list(b)}, [x, y, z], {points_of(corners)})"
    at = ", ".join(f"{name}={written(c)}" for name, c in zip("xyz", p))
    # So that all three occur.
    return f"subs({made} + 1009 x + 1013 y + 1019 z, {at})", q(bernstein_in_space(d, b, shares) + 1009 * p[0] + 1013 * p[1] + 1019 * p[2])


@kind
def tetrahedral_points(r):
    d, corners = r.randint(1, 3), tetrahedron(r)
    terms = {e[:3]: small(r) for e in indices_in_space(d) if r.random() < 0.6}
    terms[d, 0, 0] = Fraction(1)
    formula = " + ".join(f"({written(c)}) x^{i} y^{j} z^{k}" for (i, j, k), c in terms.items())

    def right(lines):
        found = {tuple(map(int, line.split()[:4])): Fraction(line.split()[4]) for line in lines[1:]}
        if set(found) != set(indices_in_space(d)):
            return False
        ordered = [found[e] for e in indices_in_space(d)]
        for shares in ([Fraction(1, 4)] * 4, shares_of(r, 4), shares_of(r, 4), shares_of(r, 4)):
            p = [sum(s * c[k] for s, c in zip(shares, corners)) for k in range(3)]
            direct = sum(c * p[0] ** i * p[1] ** j * p[2] ** k for (i, j, k), c in terms.items())
            if bernstein_in_space(d, ordered, shares) != direct:
                return False
        return True

    return f"tetrahedral_points({formula}, [x, y, z], {points_of(corners)}, degree={d})", Lines(right)


# ---- roots and signs ------------------------------------------------------------------------------------------------


@kind
def sturm(r):
    c = r.integers(r.randint(1, 6), 9)
    c[-1] = c[-1] or 1
    chain = [fmpq_poly(c), fmpq_poly(c).derivative()]
    while chain[-1].degree() > 0 and chain[-2] % chain[-1] != 0:
        chain.append(-(chain[-2] % chain[-1]))

    def right(found):
        found = [base.dense(base.as_mpoly(p)) for p in found]
        wanted = [p.coeffs() for p in chain]
        ratio = lambda a, b: len(a) == len(b) and b[-1] / a[-1] > 0 and all(x * b[-1] == y * a[-1] for x, y in zip(a, b))
        return len(found) == len(wanted) and all(ratio(a, b) for a, b in zip(found, wanted))

    return f"sturm({polynomial(list(map(Fraction, c)))}, variable=t)", right


@kind
def root_of(r):
    """Comparisons of a root, by the sign of the polynomial."""
    c = r.integers(r.randint(2, 5), 9)
    a, b = sorted(r.sample(range(-6, 7), 2))
    p = fmpq_poly(c)
    if p.degree() < 1 or p(a) * p(b) >= 0 or int(pari.polsturm(pari.Polrev(c, "t"), f"[{a},{b}]")) != 1:
        return None
    if p.gcd(p.derivative()).degree() > 0:
        return None
    x = a + (b - a) * Fraction(r.randint(1, 40), 41)
    less = p(q(x)) * p(b) > 0 or p(q(x)) == 0 and False
    if p(q(x)) == 0:
        return None
    text = f"root_of({polynomial(list(map(Fraction, c)))} + 0 t, {a}, {b})"
    return f"{text} < {written(x)}", Lines(lambda lines: lines[0] == ("proved" if less else "refuted"))


def negative_point(text, names):
    """The point at which an answer says that F is negative."""
    found = re.match(r"F\(([^)]*)\) = (\S+)", text)
    return [Fraction(x) for x in found[1].split(",")], Fraction(found[2])


@kind
def positivity(r):
    c = [Fraction(1)]
    for _ in range(r.randint(1, 3)):
        c = times(c, [small(r) for _ in range(r.randint(2, 3))])
    if r.random() < 0.6:
        c = times(c, c)
    c = geometry.plus(c, [Fraction(r.choice([0, 0, 1, 2]), r.choice([1, 7, 1000]))])
    p = base.upoly(c)
    if p.degree() < 1:
        return None
    a, b = sorted(r.sample(range(-5, 6), 2))
    whole, factors = base.integral(p).factor()
    odd = [f for f, k in factors if k % 2]
    # No change of sign inside, and a value that is not negative.
    inside = 0
    for f in odd:
        list_ = pari.Polrev([int(x) for x in f.coeffs()], "t")
        inside += int(pari.polsturm(list_, f"[{a},{b}]")) - sum(int(f(x) == 0) for x in (a, b))
    probe = next(a + (b - a) * Fraction(k, 97) for k in range(1, 97) if p(q(a + (b - a) * Fraction(k, 97))) != 0)
    wanted = inside == 0 and p(q(probe)) > 0

    def right(lines):
        if "a negative value" in lines[-1]:
            (x,), y = negative_point(lines[-1], "t")
            return not wanted and a <= x <= b and value(c, x) == y < 0
        return wanted and not lines[-1].startswith("error")

    return f"positivity({of(c)}, {a}, {b}, variable=t)", Lines(right)


def random_in_space(r, count, degree, size):
    exponents = [(i, j, k) for i in range(degree + 1) for j in range(degree + 1) for k in range(degree + 1) if i + j + k <= degree]
    return {e: Fraction(r.randint(-size, size)) for e in r.sample(exponents, min(count, len(exponents)))}


def product_in_space(a, b):
    found = {}
    for e, c in a.items():
        for f, d in b.items():
            key = tuple(x + y for x, y in zip(e, f))
            found[key] = found.get(key, 0) + c * d
    return found


def sum_in_space(*list_):
    found = {}
    for p in list_:
        for e, c in p.items():
            found[e] = found.get(e, 0) + c
    return found


def signs_over(r, dimension):
    """A polynomial, a region, and whether a negative point is right or no sample is negative."""
    clean = lambda p: {e: c for e, c in p.items() if not any(e[dimension:])}
    draw = lambda degree: clean(random_in_space(r, 4, degree, 4))
    which = r.randrange(4)
    if which == 0:
        p = draw(3)
    elif which == 1:
        p = sum_in_space(*(product_in_space(a, a) for a in (draw(1), draw(1), draw(1))), {(0, 0, 0): Fraction(1, r.choice([1, 10, 50]))})
    elif which == 2:
        a = draw(1)
        p = product_in_space(product_in_space(a, a), sum_in_space(draw(1), {(0, 0, 0): Fraction(9)}))
    else:
        p = sum_in_space(draw(2), {(0, 0, 0): Fraction(r.randint(0, 12))})
    p = {e: c for e, c in p.items() if c}
    if not p or all(not any(e) for e in p):
        return None
    names = "xyz"[:dimension]
    formula = " + ".join(f"({written(c)}) x^{i} y^{j} z^{k}" for (i, j, k), c in p.items()) if dimension == 3 else " + ".join(
        f"({written(c)}) x^{i} y^{j}" for (i, j, _), c in p.items()
    )
    at = lambda point: sum((c * point[0] ** i * point[1] ** j * (point[2] ** k if dimension == 3 else 1) for (i, j, k), c in p.items()), Fraction(0))
    if r.random() < 0.5:
        ends = [sorted(r.sample(range(-2, 3), 2)) for _ in range(dimension)]
        region = "[" + ", ".join(f"[{a}, {b}]" for a, b in ends) + "]"
        inside = lambda point: all(a <= x <= b for x, (a, b) in zip(point, ends))
        steps = 6
        grid = [[]]
        for a, b in ends:
            grid = [g + [a + (b - a) * Fraction(k, steps)] for g in grid for k in range(steps + 1)]
    else:
        corners = triangle(r) if dimension == 2 else tetrahedron(r)
        region = points_of(corners)

        def inside(point):
            shares = solved([[c[k] for c in corners] for k in range(dimension)] + [[Fraction(1)] * (dimension + 1)], list(point) + [Fraction(1)])
            return all(s >= 0 for s in shares)

        count = 7 if dimension == 2 else 5
        grid = []
        for e in (indices_in_space(count) if dimension == 3 else [(i, j, count - i - j) for i in range(count + 1) for j in range(count + 1 - i)]):
            grid.append([sum(Fraction(s, count) * c[k] for s, c in zip(e, corners)) for k in range(dimension)])
    samples = min(at(point) for point in grid)

    def right(lines):
        if "a negative value" in lines[-1]:
            point, y = negative_point(lines[-1], names)
            return inside(point) and at(point) == y < 0
        return samples >= 0 and not lines[-1].startswith("error")

    return f"positivity_over({formula}, {region}, [{', '.join(names)}])", Lines(right)


@kind
def positivity_in_the_plane(r):
    return signs_over(r, 2)


@kind
def positivity_in_space(r):
    return signs_over(r, 3)


@kind
def groebner(r):
    """A basis of a line of points: both ideals have the same zeros, and each generator is 0 there."""
    points = sorted({(Fraction(r.randint(-3, 3)), Fraction(r.randint(-3, 3))) for _ in range(r.randint(1, 3))})
    if len({p[0] for p in points}) < len(points):
        return None
    eliminant = [Fraction(1)]
    for x, _ in points:
        eliminant = times(eliminant, [-x, Fraction(1)])
    n = len(points)
    line = solved([[p[0] ** k for k in range(n)] for p in points], [p[1] for p in points])
    noise = r.randint(-2, 2)
    first = polynomial(eliminant, "x")
    second = f"y - ({polynomial(line, 'x')}) + ({noise}) ({first})"

    def right(found):
        zero = all(p(*[q({"x": a, "y": b}.get(name, 0)) for name in base.NAMES]) == 0 for p in map(base.as_mpoly, found) for a, b in points)
        lowest = [p for p in map(base.as_mpoly, found) if p.degrees()[base.NAMES.index("y")] == 0]
        return zero and len(found) == 2 and len(lowest) == 1 and lowest[0].degrees()[base.NAMES.index("x")] == n

    return f"groebner([{second}, {first}], [y, x])", right


# ---- subdivision ----------------------------------------------------------------------------------------------------


def refined(points, rule):
    """One step on a closed polygon: [offset, weights] for even and odd points."""
    m = len(points)
    found = []
    for i in range(m):
        for offset, weights in rule:
            found.append([sum(w * points[(i + offset + k) % m][a] for k, w in enumerate(weights)) for a in range(len(points[0]))])
    return found


F = Fraction
RULES = {
    "chaikin": [(0, [F(3, 4), F(1, 4)]), (0, [F(1, 4), F(3, 4)])],
    "cubic": [(-1, [F(1, 8), F(6, 8), F(1, 8)]), (0, [F(1, 2), F(1, 2)])],
    "four_point": [(0, [F(1)]), (-1, [F(-1, 16), F(9, 16), F(9, 16), F(-1, 16)])],
}


def scheme(r):
    """The scheme as typed, and one step."""
    which = r.choice(["chaikin", "cubic", "four_point", "lane_riesenfeld", "corner_cutting"])
    if which in RULES:
        return which, lambda points: refined(points, RULES[which])
    if which == "corner_cutting":
        a, b = F(r.randint(1, 4), 10), F(r.randint(1, 4), 10)
        return f"[corner_cutting, {written(a)}, {written(b)}]", lambda points: refined(points, [(0, [1 - a, a]), (0, [b, 1 - b])])
    n = r.randint(1, 5)

    def step(points):
        points = [p for p in points for _ in range(2)]
        for _ in range(n):
            points = [[(x + y) / 2 for x, y in zip(a, b)] for a, b in zip(points, points[1:] + points[:1])]
        return points

    return f"[lane_riesenfeld, {n}]", step


def turned(found, wanted):
    """Equal up to where one begins."""
    wanted = [same(p) for p in wanted]
    return any(found == wanted[k:] + wanted[:k] for k in range(len(wanted)))


@kind
def subdivide_polygon(r):
    name, step = scheme(r)
    points, k = some_points(r, r.randint(3, 7), 2), r.randint(1, 2)
    wanted = points
    for _ in range(k):
        wanted = step(wanted)
    return f"subdivide_polygon({points_of(points)}, {name}, {k}, closed=1)", lambda found: turned(found, wanted)


@kind
def subdivision_matrix(r):
    name, step = scheme(r)
    points = some_points(r, r.randint(3, 7), 2)
    wanted = step(points)

    def right(matrix):
        product = [[sum((x * q(p[a]) for x, p in zip(row, points)), fmpq(0)) for a in range(2)] for row in matrix]
        return turned(product, wanted)

    return f"subdivision_matrix({name}, {len(points)}, closed=1)", right


@kind
def sum_rules(r):
    mask, k = numbers(r, r.randint(1, 4)), r.randint(0, 5)
    if sum(mask) == 0 or not mask[-1] or not mask[0]:
        return None
    order = 0
    alternating = lambda p: sum((-1) ** i * x for i, x in enumerate(p))
    whole = mask
    for _ in range(k):
        whole = times(whole, [F(1), F(1)])
    rest = whole
    while alternating(rest) == 0 and len(rest) > 1:
        order += 1
        # Divided by 1 + z.
        found, carry = [], F(0)
        for c in rest[:-1]:
            carry = c - carry
            found.append(carry)
        rest = found
    scale = 2 / sum(whole)
    return f"sum_rules({in_list([scale * c for c in whole])})", fmpq(order)


@kind
def subdivision_mask(r):
    n = r.randint(1, 8)
    if r.random() < 0.5:
        return f"subdivision_mask([lane_riesenfeld, {n}])", same([F(comb(n + 1, k), 2**n) for k in range(n + 2)])
    z = small(r) or F(2)
    value_ = (1 + z) ** (n + 1) / F(2**n)
    # Up to a power of z.
    right = lambda found: any(found == q(value_ / z**k) for k in range(n + 3))
    return f"subs(subdivision_symbol([lane_riesenfeld, {n}]), z={written(z)})", right


@kind
def limit_derivatives(r):
    """Splines over the integers: N_n' = N_(n-1)(x) - N_(n-1)(x - 1)."""
    n, m = r.choice([2, 3, 4, 5]), r.randint(3, 7)
    points = some_points(r, m, 2)
    knots = [F(k) for k in range(n + 3)]
    low = lambda x: cox(knots, 0, n - 1, x, F(-100)) if 0 <= x < n else F(0)
    shift = F(n + 1, 2) if n % 2 else F(n, 2)
    wanted = []
    for i in range(m):
        total = [F(0)] * 2
        for k in range(-n - 2, n + 3):
            weight = low(shift - k) - low(shift - k - 1)
            total = [a + weight * b for a, b in zip(total, points[(i + k) % m])]
        wanted.append(same(total))
    return f"limit_points({points_of(points)}, [lane_riesenfeld, {n}], 1, closed=1)", wanted


@kind
def eigenvalues(r):
    n = r.randint(2, 5)
    values = [F(r.randint(-4, 4), r.choice([1, 1, 2])) for _ in range(n)]
    p = [[F(int(i == j)) for j in range(n)] for i in range(n)]
    for _ in range(2 * n):
        i, j = r.sample(range(n), 2)
        k = r.randint(-2, 2)
        p[i] = [x + k * y for x, y in zip(p[i], p[j])]
    matrix = fmpq_mat([[q(x) for x in row] for row in p])
    diagonal = fmpq_mat([[q(values[i]) if i == j else fmpq(0) for j in range(n)] for i in range(n)])
    whole = (matrix * diagonal * matrix.inv()).tolist()

    def right(lines):
        found = {F(line.split()[0]): int(line.split()[1]) for line in lines[1:]}
        return found == {x: values.count(x) for x in values}

    return f"eigenvalues({rows([[fraction(x) for x in row] for row in whole])})", Lines(right)


def around(scheme_, n):
    """The rows of a step around a vertex, by the rules of the scheme, and the number of its points."""
    c = cos(2 * pi / n)
    if scheme_ == "doo_sabin":
        first = [(3 + 2 * cos(2 * pi * j / n)) / (4 * n) for j in range(n)]
        first[0] = (n + 5) / (4 * n)
        return [[first[(j - i) % n] for j in range(n)] for i in range(n)]
    if scheme_ in ("loop", "warren"):
        if scheme_ == "loop":
            beta = (5 / 8 - (3 / 8 + c / 4) ** 2) / n
        else:
            beta = 3 / 16 if n == 3 else 3 / (8 * n)
        found = [[1 - n * beta] + [beta] * n]
        for i in range(n):
            row = [3 / 8] + [0.0] * n
            row[1 + i] = 3 / 8
            row[1 + (i + 1) % n] += 1 / 8
            row[1 + (i - 1) % n] += 1 / 8
            found.append(row)
        return found
    # Catmull and Clark: faces, edges, the vertex.
    size = 2 * n + 1
    unit = lambda k: numpy.eye(size)[k]
    edge, corner = lambda i: unit(1 + i % n), lambda i: unit(1 + n + i % n)
    face = lambda i: (unit(0) + edge(i) + edge(i + 1) + corner(i)) / 4
    middle = lambda i: (unit(0) + edge(i) + face(i) + face(i - 1)) / 4
    mean_face = sum(face(i) for i in range(n)) / n
    mean_edge = sum((unit(0) + edge(i)) / 2 for i in range(n)) / n
    vertex_ = (mean_face + 2 * mean_edge + (n - 3) * unit(0)) / n
    return [list(vertex_)] + [list(middle(i)) for i in range(n)] + [list(face(i)) for i in range(n)]


@kind
def vertex(r):
    name, n = r.choice(["catmull_clark", "doo_sabin", "loop", "warren"]), r.randint(3, 24)
    matrix = numpy.array(around(name, n))
    which = r.choice(["matrix", "limit", "eigenvalues"])
    near = lambda a, b: abs(a - b) < 1e-9
    number = lambda text: eval(re.sub(r"(\d|\)) (?=c)", r"\1*", text).replace("^", "**"), {"c": cos(2 * pi / n), "__builtins__": {}})
    if which == "matrix":

        def right(lines):
            found = [[number(x) for x in row.split(",")] for row in lines[0].strip("[]").split(";")]
            return len(found) == len(matrix) and all(near(x, y) for a, b in zip(found, matrix) for x, y in zip(a, b))

        return f"vertex_matrix({name}, {n})", Lines(right)
    if which == "limit":

        def right(lines):
            weights = numpy.array([number(x) for x in lines[0].strip("[]").split(",")])
            return near(sum(weights), 1) and all(near(x, y) for x, y in zip(weights @ matrix, weights))

        return f"vertex_limit({name}, {n})", Lines(right)

    def right(lines):
        found = []
        for line in lines[1:]:
            text, count = line.rsplit(None, 1)
            if "root_of" in text:
                low, high = map(Fraction, text.strip(") ").split(", ")[-2:])
                found.append((float(low), float(high), int(count)))
            else:
                found.append((float(Fraction(text)), float(Fraction(text)), int(count)))
        mine = sorted(numpy.linalg.eigvals(matrix).real)
        left = list(mine)
        # Each interval takes as many as it says, the shortest intervals first.
        for low, high, count in sorted(found, key=lambda x: x[1] - x[0]):
            inside = [x for x in left if low - 1e-6 <= x <= high + 1e-6]
            if len(inside) < count:
                return False
            for x in inside[:count]:
                left.remove(x)
        return not left

    return f"vertex_eigenvalues({name}, {n})", Lines(right)


# ---- intersections --------------------------------------------------------------------------------------------------


@kind
def double_points(r):
    s, t = sorted(r.sample(range(-3, 4), 2))
    factor = times([F(-s), F(1)], [F(-t), F(1)])
    lists = [geometry.plus(times(factor, integers(r, 2)), [F(k)]) for k in (5, -1)]
    if fmpq_mat([[q(x) for x in geometry.plus(p, [F(0)] * 4)[1:]] for p in lists]).rank() < 2:
        return None

    def right(lines):
        pairs = [line.split()[:2] for line in lines[1:] if "root_of" not in line]
        pairs = [tuple(map(F, pair)) for pair in pairs]
        return (s, t) in pairs and all([value(p, a) for p in lists] == [value(p, b) for p in lists] for a, b in pairs)

    return f"double_points([{', '.join(map(of, lists))}])", Lines(right)


@kind
def inversion(r):
    lists = [integers(r, r.randint(2, 4)) for _ in range(2)]
    t = F(r.randint(-4, 4), r.choice([1, 2]))
    if not any(lists[0][1:]) and not any(lists[1][1:]):
        return None
    point = [value(p, t) for p in lists]

    def right(lines):
        found = re.findall(r"-?\d+(?:/\d+)?", re.sub(r"root_of\([^)]*\)", "", lines[0]))
        return q(t) in [q(F(x)) for x in found]

    return f"inversion([{', '.join(map(of, lists))}], ({written(point[0])}, {written(point[1])}))", Lines(right)


@kind
def moving_lines(r):
    n = r.randint(2, 4)
    lists = [integers(r, n + 1) for _ in range(2)]
    if fmpq_mat([[q(x) for x in p[1:]] for p in lists]).rank() < 2:
        return None
    degree = max(k for p in lists for k, c in enumerate(p) if c)

    def right(found):
        places = [F(k, 2) for k in range(-9, 10)]
        on = lambda p, t: p(*[q({"t": t, "x": value(lists[0], t), "y": value(lists[1], t)}.get(name, 0)) for name in base.NAMES])
        found = [base.as_mpoly(p) for p in found]
        in_t = [p.degrees()[base.NAMES.index("t")] for p in found]
        return sum(in_t) == degree and all(on(p, t) == 0 for p in found for t in places)

    return f"moving_lines([{', '.join(map(of, lists))}])", right


@kind
def curve_on_patch(r):
    """A curve that meets a patch at planted parameters; all rational rows are common points."""
    lists = [{(i, j): F(r.randint(-3, 3)) for i in range(2) for j in range(2)} for _ in range(3)]
    u, v, t = F(r.randint(0, 4), 4), F(r.randint(0, 4), 4), F(r.randint(0, 3), 3)
    curve = [integers(r, r.randint(2, 3)) for _ in range(3)]
    for p, surface in zip(curve, lists):
        p[0] += value_in_two(surface, u, v) - value(p, t)
    if all(not any(p[1:]) for p in curve):
        return None

    def right(lines):
        if lines == "error: infinitely many, or none":
            # The curve runs on the surface, or the surface is no surface.
            return degenerate(lists, curve)
        found = [tuple(map(F, line.split()[:3])) for line in lines[1:] if "root_of" not in line]
        on = all([value(p, a) for p in curve] == [value_in_two(s, b, c) for s in lists] for a, b, c in found)
        return on and (t, u, v) in found

    return f"intersections([{', '.join(map(of, curve))}], [{', '.join(two(p) + ' + 0 u + 0 v' for p in lists)}])", Lines(right)


def degenerate(lists, curve):
    """Whether a curve has more than 60 points near a bilinear surface, or it degenerates: its equation vanishes on the curve."""
    vectors = [[q(p[e]) for e in [(1, 0), (0, 1), (1, 1)]] for p in lists]
    if fmpq_mat(vectors).rank() < 3:
        return True
    # (u, v, uv) of a point by linear equations; on the surface if the third is the product.
    matrix = fmpq_mat(vectors)
    for k in range(-8, 9):
        found = matrix.solve(fmpq_mat([[q(value(p, F(k, 3)) - s[0, 0])] for p, s in zip(curve, lists)]))
        if found[0, 0] * found[1, 0] != found[2, 0]:
            return False
    return True


@kind
def implicit_patch(r):
    """The equation of a biquadratic patch is 0 at its points and irreducible."""
    lists = [{(i, j): F(r.randint(-2, 2)) for i in range(3) for j in range(3)} for _ in range(3)]

    def right(found):
        places = [[value_in_two(p, F(i), F(j, 2)) for p in lists] for i in range(-3, 4) for j in range(-3, 4)]
        return all(geometry.on(found, place) == 0 for place in places) and found.total_degree() <= 8

    return f"implicit_surface([{', '.join(two(p) + ' + 0 u + 0 v' for p in lists)}])", right


@kind
def intersections_in_the_plane(r):
    """Planted common points of two plane curves, and of a curve and an equation."""
    a = [integers(r, r.randint(2, 4)) for _ in range(2)]
    t = F(r.randint(-3, 3))
    if not any(a[0][1:]) and not any(a[1][1:]):
        return None
    c = {(i, j): F(r.randint(-3, 3)) for i in range(3) for j in range(3 - i)}
    x, y = (value(p, t) for p in a)
    c[0, 0] = -value_in_two({e: k for e, k in c.items() if e != (0, 0)}, x, y)
    if not any(c.values()):
        return None
    on = lambda s: value_in_two(c, value(a[0], s), value(a[1], s))

    def right(lines):
        if lines == "error: infinitely many, or none":
            return all(on(F(k)) == 0 for k in range(-6, 7))
        found = [F(line.split()[0]) for line in lines[1:] if "root_of" not in line]
        return t in found and all(on(s) == 0 for s in found)

    return f"intersections([{', '.join(map(of, a))}], {two(c, 'xy')})", Lines(right)


# ---- differential geometry ------------------------------------------------------------------------------------------


@kind
def arc_length(r):
    points = some_points(r, r.randint(2, 4), r.choice([2, 3]))
    if len(set(map(tuple, points))) < 2:
        return None
    lists = [slope(p) for p in powers(points)]
    speed_ = lambda t: hypot(*(float(value(p, F(t).limit_denominator(10**9))) for p in lists))
    wanted, error = quad(speed_, 0, 1, limit=200)

    def right(found):
        low, high = (found, found) if not isinstance(found, list) else found
        return float(fraction(low)) - 1e-5 <= wanted <= float(fraction(high)) + 1e-5

    return f"arc_length({bezier_of(points)}, width=1/20)", right


@kind
def pythagorean(r):
    u, v = (integers(r, r.randint(1, 3)) for _ in "uv")
    start = some_points(r, 1, 2)[0]
    derivative = [geometry.plus(times(u, u), times(v, v), -1), times([F(2)], times(u, v))]
    if not any(derivative[0]) and not any(derivative[1]):
        return None
    t = F(r.randint(0, 6), 6)
    lists = [[s] + [c / (k + 1) for k, c in enumerate(p)] for s, p in zip(start, derivative)]
    made = f"pythagorean_curve({of(u)}, {of(v)}, {in_list(start).replace('[', '(').replace(']', ')')})"
    if r.random() < 0.5:
        return f"({made})({written(t)})", same([value(p, t) for p in lists])
    total = value(geometry.plus(times(u, u), times(v, v)), t)
    return f"subs(speed({made}), t={written(t)})^2", q(total**2)


@kind
def inflections(r):
    points = some_points(r, r.randint(3, 5), 2)
    x, y = powers(points)
    x1, y1 = slope(x), slope(y)
    turn = geometry.plus(times(x1, slope(y1)), times(y1, slope(x1)), -1)
    p = base.upoly(turn)
    if p.degree() < 0 or base.upoly(x1).gcd(base.upoly(y1)).degree() > 0:
        return None
    count = 0
    if p.degree() > 0:
        for f, k in base.integral(p).factor()[1]:
            if k % 2:
                list_ = pari.Polrev([int(c) for c in f.coeffs()], "t")
                count += int(pari.polsturm(list_, "[0,1]")) - sum(int(f(e) == 0) for e in (0, 1))

    def right(lines):
        text = lines[0]
        if not text.startswith("["):
            return count == 0
        return len(re.findall(r"root_of\(", text)) + len([x for x in re.sub(r"root_of\([^)]*\)", "", text).strip("[]").split(",") if x.strip()]) == count

    return f"inflections({bezier_of(points)})", Lines(right)


def forms_of(net, u, v):
    """E, F, G and L, M, N times the length of the normal, of a patch over the unit square."""
    m, n = len(net) - 1, len(net[0]) - 1
    lists = []
    for axis in range(3):
        in_v = [powers([[p[axis]] for p in row])[0] for row in net]
        columns = [powers([[row[j]] for row in in_v])[0] for j in range(n + 1)]
        lists.append({(i, j): columns[j][i] for i in range(m + 1) for j in range(n + 1)})

    def d(p, i, j):
        total = F(0)
        for (a, b), c in p.items():
            if a >= i and b >= j:
                total += c * geometry.falling(a, i) * geometry.falling(b, j) * u ** (a - i) * v ** (b - j)
        return total

    at = lambda i, j: [d(p, i, j) for p in lists]
    su, sv = at(1, 0), at(0, 1)
    normal = cross(su, sv)
    return [dot(su, su), dot(su, sv), dot(sv, sv)], [dot(at(2, 0), normal), dot(at(1, 1), normal), dot(at(0, 2), normal)], normal


@kind
def surface_curvature(r):
    net = [some_points(r, r.choice([2]) + 1, 3, 3) for _ in range(r.randint(2, 3))]
    u, v = F(r.randint(0, 6), 6), F(r.randint(0, 6), 6)
    (e, f, g), (l, m, n), normal = forms_of(net, u, v)
    w = e * g - f * f
    if w == 0:
        return None
    shown = f"patch({net_of(net)}), {written(u)}, {written(v)}"
    if r.random() < 0.5:
        return f"gaussian_curvature({shown})", q((l * n - m * m) / w**2)
    return f"squared_mean_curvature({shown})", q((e * n - 2 * f * m + g * l) ** 2 / (4 * w**3))


@kind
def normal_of_patch(r):
    net = [some_points(r, 3, 3, 3) for _ in range(r.randint(2, 3))]
    u, v = F(r.randint(0, 6), 6), F(r.randint(0, 6), 6)
    _, _, normal = forms_of(net, u, v)
    if not any(normal):
        return None
    return f"normal_at(patch({net_of(net)}), {written(u)}, {written(v)})", same(normal)


@kind
def geometric_continuity(r):
    """G(x) with the derivatives of F(φ(x)): β_1, β_2 are those of φ."""
    k = r.randint(1, 2)
    c = some_points(r, 4, 2)
    _, a, b = jet_of(c, F(1), 3)
    if cross(a + [F(0)], b + [F(0)])[2] == 0:
        return None
    b1, b2 = F(r.randint(1, 4), r.choice([1, 2])), small(r)
    first = [b1 * x for x in a]
    second = [b1**2 * y + b2 * x for x, y in zip(a, b)]
    noise = some_points(r, 1, 2)[0]
    # A cubic over [0, 1] with these derivatives at 0.
    d = [c[3], [p + x / 3 for p, x in zip(c[3], first)]]
    d.append([y / 6 + 2 * q1 - p for y, q1, p in zip(second, d[1], d[0])])
    if k == 1:
        d[2] = [x + y for x, y in zip(d[2], noise)]
    d.append(some_points(r, 1, 2)[0])

    def right(lines):
        words = lines[1].split()
        if k == 1 and cross([x - y for x, y in zip(d[2], d[1])] + [F(0)], first + [F(0)])[2] != 0:
            return words[0] in ("G^1", "G^2") and F(words[1]) == b1
        return words[0] == "G^2" and F(words[1]) == b1 and F(words[2]) == b2 if k == 2 else words[0] in ("G^1", "G^2")

    return f"geometric_continuity({bezier_of(c)}, {bezier_of(d)}, 2)", Lines(right)


# ---- curves and data ------------------------------------------------------------------------------------------------


@kind
def hodograph(r):
    points, t = some_points(r, r.randint(2, 5), 2), F(r.randint(0, 8), 8)
    _, wanted = jet_of(points, t, 2)
    return f"(hodograph({bezier_of(points)}))({written(t)})", same(wanted)


@kind
def curve_product(r):
    a, b, t = numbers(r, r.randint(1, 4)), numbers(r, r.randint(1, 4)), F(r.randint(0, 8), 8)
    wanted = casteljau(a, t)[0] * casteljau(b, t)[0]
    return f"(curve_product({bezier_of(a)}, {bezier_of(b)}))({written(t)})", q(wanted)


@kind
def barycentric(r):
    corners = triangle(r)
    shares = shares_of(r, 3)
    p = mixed(corners, shares)
    names = ", ".join("(" + ", ".join(map(written, c)) + ")" for c in corners)
    return f"barycentric(({', '.join(map(written, p))}), [{names}])", same(shares)


@kind
def convex_hull(r):
    points = [[F(r.randint(-4, 4)), F(r.randint(-4, 4))] for _ in range(r.randint(3, 8))]
    turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    list_ = sorted(set(map(tuple, points)))

    def half(list_):
        found = []
        for p in list_:
            while len(found) > 1 and turn(found[-2], found[-1], p) <= 0:
                found.pop()
            found.append(p)
        return found[:-1]

    wanted = sorted(half(list_) + half(list_[::-1])) if len(list_) > 1 else list_
    shown = "[" + ", ".join(f"({written(a)}, {written(b)})" for a, b in points) + "]"
    return f"convex_hull({shown})", lambda found: sorted(map(tuple, found)) == sorted(tuple(q(x) for x in p) for p in wanted)


@kind
def hermite(r):
    nodes = r.increasing(r.randint(1, 3), 4)
    data = [numbers(r, r.randint(1, 3)) for _ in nodes]
    size = sum(map(len, data))
    table, right_ = [], []
    for x, list_ in zip(nodes, data):
        for k, y in enumerate(list_):
            table.append([geometry.falling(e, k) * x ** (e - k) if e >= k else F(0) for e in range(size)])
            right_.append(y)
    c = solved(table, right_)
    t = small(r)
    shown = ", ".join(in_list([x] + list_) for x, list_ in zip(nodes, data))
    return f"hermite([{shown}])({written(t)})", q(value(c, t))


@kind
def least_squares(r):
    n = r.randint(0, 3)
    x = r.increasing(r.randint(n + 2, n + 5), 6)
    y = numbers(r, len(x))
    table = [[sum(a ** (i + j) for a in x) for j in range(n + 1)] for i in range(n + 1)]
    c = solved(table, [sum(b * a**i for a, b in zip(x, y)) for i in range(n + 1)])
    t = small(r)
    return f"least_squares({in_list(x)}, {in_list(y)}, {n})({written(t)})", q(value(c, t))


@kind
def smoothing_spline(r):
    """Normal equations with the Gram matrix of derivatives."""
    n = r.randint(1, 3)
    knots = geometry.clamped(r, n, r.randint(0, 2))
    m, end, order = len(knots) - n - 1, knots[-1], r.randint(1, n)
    x = [knots[0] + (end - knots[0]) * F(k, m + 1) for k in range(m + 2)]
    y, weight = numbers(r, len(x)), F(r.randint(1, 5), r.choice([1, 10]))

    def derived(i, t, k):
        """N_i^{(k)} by differences of functions of lower degree, from the right."""
        def part(i, degree, k):
            if k == 0:
                return cox(knots, i, degree, t, F(-1000))
            total = F(0)
            if knots[i + degree] != knots[i]:
                total += degree / (knots[i + degree] - knots[i]) * part(i, degree - 1, k - 1)
            if knots[i + degree + 1] != knots[i + 1]:
                total -= degree / (knots[i + degree + 1] - knots[i + 1]) * part(i + 1, degree - 1, k - 1)
            return total
        return part(i, n, k)

    def product(i, j):
        total, degree = F(0), 2 * (n - order)
        for a, b in zip(knots, knots[1:]):
            if a != b:
                # Values inside of the interval, so that no end counts.
                nodes = [a + (b - a) * F(k + 1, degree + 3) for k in range(degree + 1)]
                weights = solved([[s**k for s in nodes] for k in range(degree + 1)], [(b ** (k + 1) - a ** (k + 1)) / (k + 1) for k in range(degree + 1)])
                total += sum(w * derived(i, s, order) * derived(j, s, order) for w, s in zip(weights, nodes))
        return total

    a = [[cox(knots, i, n, t, end) for i in range(m)] for t in x]
    table = [[sum(row[i] * row[j] for row in a) + weight * product(i, j) for j in range(m)] for i in range(m)]
    d = solved(table, [sum(row[i] * z for row, z in zip(a, y)) for i in range(m)])
    if d is None:
        return None
    query = f"least_squares_spline({n}, {in_list(knots)}, {in_list(x)}, {in_list(y)}, smoothing={written(weight)}, derivative={order})"
    return f"control_points({query})", same(d)


@kind
def linear_system(r):
    """50 equations now and then."""
    n = r.choice([2, 5, 10, 20]) if r.random() < 0.97 else 50
    matrix = [[F(r.randint(-9, 9)) for _ in range(n)] for _ in range(n)]
    right_ = numbers(r, n)
    wanted = solved(matrix, right_)
    if wanted is None:
        return None
    return f"solve({rows(matrix)}, {in_list(right_)})", lambda found: base.flat(found) == same(wanted)


if __name__ == "__main__":
    geometry.main(KINDS)

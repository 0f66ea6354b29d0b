#!/usr/bin/env python3
"""Random queries about curves, surfaces, blossoms, splines and integrals, against definitions in plain fractions.

    python3 -m venv venv && venv/bin/pip install python-flint cypari scipy
    venv/bin/python tests/differential_geometry.py --each 500 [--seed 1] [--only gordon] [--program target/release/polarform]

Optional: no part of `cargo test`. Each function has a second way here: sums, systems of linear equations, integrals of
polynomials by their values. `--each` is the number of cases for each function.
"""
import argparse, collections, subprocess, sys, time, types
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, permutations
from math import comb, factorial

import differential as base
import flint
from differential import Draw, answers, in_list, q, value_of, written
from flint import fmpq, fmpq_mat

KINDS = {}


def kind(build):
    KINDS[build.__name__] = build
    return build


# ---- polynomials as lists of fractions ------------------------------------------------------------------------------


def value(p, t):
    found = Fraction(0)
    for c in reversed(p):
        found = found * t + c
    return found


def times(p, r):
    found = [Fraction(0)] * (len(p) + len(r) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(r):
            found[i + j] += a * b
    return found


def plus(p, r, factor=1):
    length = max(len(p), len(r))
    at = lambda list_, i: list_[i] if i < len(list_) else Fraction(0)
    return [at(p, i) + factor * at(r, i) for i in range(length)]


def slope(p):
    return [k * c for k, c in enumerate(p)][1:] or [Fraction(0)]


def casteljau(points, t):
    """The value of a Bézier curve over [0, 1]; points are numbers or lists."""
    level = [list(p) if isinstance(p, (list, tuple)) else [p] for p in points]
    while len(level) > 1:
        level = [[(1 - t) * x + t * y for x, y in zip(a, b)] for a, b in zip(level, level[1:])]
    return level[0]


def powers(points):
    """Power coefficients of each coordinate of a Bézier curve over [0, 1], by differences."""
    n = len(points) - 1
    coordinates = []
    for k in range(len(points[0])):
        list_ = [Fraction(p[k]) for p in points]
        found = []
        for i in range(n + 1):
            found.append(comb(n, i) * list_[0])
            list_ = [b - a for a, b in zip(list_, list_[1:])]
        coordinates.append(found)
    return coordinates


def solved(rows, right):
    """The solution of a square system, None if it is singular."""
    matrix = fmpq_mat([[q(x) for x in row] for row in rows])
    if matrix.det() == 0:
        return None
    found = matrix.solve(fmpq_mat([[q(x)] for x in right]))
    return [Fraction(int(found[i, 0].p), int(found[i, 0].q)) for i in range(len(rows))]


def integral(f, a, b, degree):
    """Of a polynomial of some degree, by values and the weights that are exact for powers."""
    nodes = [a + (b - a) * Fraction(k, max(degree, 1)) for k in range(degree + 1)]
    rows = [[x**k for x in nodes] for k in range(degree + 1)]
    weights = solved(rows, [(b ** (k + 1) - a ** (k + 1)) / (k + 1) for k in range(degree + 1)])
    return sum(w * f(x) for w, x in zip(weights, nodes))


def cox(knots, i, n, t, end):
    """N_i^n(t) by the recurrence; at the end of the domain from the left."""
    if n == 0:
        inside = knots[i] < t <= knots[i + 1] if t == end else knots[i] <= t < knots[i + 1]
        return Fraction(int(inside))
    found = Fraction(0)
    if knots[i + n] != knots[i]:
        found += (t - knots[i]) / (knots[i + n] - knots[i]) * cox(knots, i, n - 1, t, end)
    if knots[i + n + 1] != knots[i + 1]:
        found += (knots[i + n + 1] - t) / (knots[i + n + 1] - knots[i + 1]) * cox(knots, i + 1, n - 1, t, end)
    return found


def blossom(knots, points, n, j, arguments):
    """The polar form of the piece over [t_j, t_(j+1)] by de Boor's algorithm."""
    level = [list(points[i]) for i in range(j - n, j + 1)]
    for k, u in enumerate(arguments, 1):
        step = []
        for i in range(j - n + k, j + 1):
            a = (u - knots[i]) / (knots[i + n + 1 - k] - knots[i])
            low, high = level[i - j + n - k], level[i - j + n - k + 1]
            step.append([(1 - a) * x + a * y for x, y in zip(low, high)])
        level = step
    return level[0]


def elementary(list_, k):
    found = Fraction(0)
    for chosen in combinations(list_, k):
        product = Fraction(1)
        for x in chosen:
            product *= x
        found += product
    return found


def power_form(c, arguments):
    """The polar form of Σ c_k t^k."""
    n = len(arguments)
    return sum((c[k] * elementary(arguments, k) / comb(n, k) for k in range(len(c))), Fraction(0))


# ---- as it is typed -------------------------------------------------------------------------------------------------


def points_of(points):
    return "[" + ", ".join(in_list(p) if isinstance(p, (list, tuple)) else written(p) for p in points) + "]"


def net_of(net):
    return "[" + ", ".join(points_of(row) for row in net) + "]"


def bezier_of(points, ends=None):
    tail = "" if ends is None else f", {written(ends[0])}, {written(ends[1])}"
    return f"bezier({points_of(points)}{tail})"


def at(surface, *parameters):
    return f"(s -> s({', '.join(map(written, parameters))}))({surface})"


def small(r, size=5):
    return Fraction(r.randint(-size, size), r.choice([1, 1, 1, 2, 3]))


def numbers(r, count, size=5):
    return [small(r, size) for _ in range(count)]


def integers(r, count, size=3):
    return [Fraction(r.randint(-size, size)) for _ in range(count)]


def some_points(r, count, dimension, size=5):
    return [numbers(r, dimension, size) for _ in range(count)]


def same(wanted):
    """Equal to numbers in a list, or to one."""
    wanted = [q(x) for x in wanted] if isinstance(wanted, list) else q(wanted)
    return wanted


def two(p, names="uv"):
    """A polynomial in two variables, by its coefficients c_ij."""
    parts = [f"({written(c)}) {names[0]}^{i} {names[1]}^{j}" for (i, j), c in p.items() if c]
    return " + ".join(parts) or "0"


def value_in_two(p, u, v):
    return sum((c * u**i * v**j for (i, j), c in p.items()), Fraction(0))


# ---- surfaces of curves ---------------------------------------------------------------------------------------------


@kind
def ruled(r):
    d = r.randint(1, 3)
    a, b = some_points(r, r.randint(1, 5), d), some_points(r, r.randint(1, 5), d)
    if d == 1 or len(a) == 1 or len(b) == 1:
        a, b = some_points(r, r.randint(2, 5), 3), some_points(r, r.randint(2, 5), 3)
    u, v = small(r), small(r)
    wanted = [(1 - v) * x + v * y for x, y in zip(casteljau(a, u), casteljau(b, u))]
    return f"extended(ruled({bezier_of(a)}, {bezier_of(b)}), {written(u)}, {written(v)})", same(wanted)


@kind
def sweep(r):
    d = r.choice([2, 3])
    a, b = some_points(r, r.randint(2, 5), d), some_points(r, r.randint(2, 5), d)
    u, v = small(r), small(r)
    wanted = [x + y - z for x, y, z in zip(casteljau(a, u), casteljau(b, v), b[0])]
    return f"extended(sweep({bezier_of(a)}, {bezier_of(b)}), {written(u)}, {written(v)})", same(wanted)


def lagrange(nodes, i, t):
    found = Fraction(1)
    for j, x in enumerate(nodes):
        if j != i:
            found *= (t - x) / (nodes[i] - x)
    return found


def control_points(p, n, a, b):
    """Bézier points over [a, b] of a polynomial of degree at most n, as polar values."""
    return [power_form(p, [a] * (n - i) + [b] * i) for i in range(n + 1)]


def network(r, us, vs):
    """Curves of a surface with random polynomials as coordinates, and blended curves through them."""
    dimension = r.choice([2, 3])
    m, n = r.randint(1, 4), r.randint(1, 4)
    net = [{(i, j): small(r, 3) for i in range(m + 1) for j in range(n + 1)} for _ in range(dimension)]

    def along_u(v):
        lists = [[sum((p[i, j] * v**j for j in range(n + 1)), Fraction(0)) for i in range(m + 1)] for p in net]
        return list(zip(*[control_points(list_, m, us[0], us[-1]) for list_ in lists]))

    def along_v(u):
        lists = [[sum((p[i, j] * u**i for i in range(m + 1)), Fraction(0)) for j in range(n + 1)] for p in net]
        return list(zip(*[control_points(list_, n, vs[0], vs[-1]) for list_ in lists]))

    surface = lambda u, v: [value_in_two(p, u, v) for p in net]
    return surface, [along_u(v) for v in vs], [along_v(u) for u in us]


def blended(surface, us, vs, u, v):
    """Gordon's formula at a pair of numbers."""
    found = None
    parts = [(lagrange(us, i, u), surface(x, v)) for i, x in enumerate(us)]
    parts += [(lagrange(vs, j, v), surface(u, y)) for j, y in enumerate(vs)]
    parts += [
        (-lagrange(us, i, u) * lagrange(vs, j, v), surface(x, y)) for i, x in enumerate(us) for j, y in enumerate(vs)
    ]
    for weight, point in parts:
        scaled = [weight * x for x in point]
        found = scaled if found is None else [x + y for x, y in zip(found, scaled)]
    return found


@kind
def gordon(r):
    us, vs = r.increasing(r.randint(2, 4), 4), r.increasing(r.randint(2, 4), 4)
    surface, in_u, in_v = network(r, us, vs)
    u, v = small(r), small(r)
    curves_u = ", ".join(bezier_of(c, (us[0], us[-1])) for c in in_u)
    curves_v = ", ".join(bezier_of(c, (vs[0], vs[-1])) for c in in_v)
    made = f"gordon([{curves_u}], {in_list(vs)}, [{curves_v}], {in_list(us)})"
    return f"extended({made}, {written(u)}, {written(v)})", same(blended(surface, us, vs, u, v))


@kind
def coons(r):
    us, vs = r.increasing(2, 4), r.increasing(2, 4)
    surface, in_u, in_v = network(r, us, vs)
    u, v = small(r), small(r)
    curves = [bezier_of(c, (us[0], us[-1])) for c in in_u] + [bezier_of(c, (vs[0], vs[-1])) for c in in_v]
    return f"extended(coons({', '.join(curves)}), {written(u)}, {written(v)})", same(blended(surface, us, vs, u, v))


@kind
def torus(r):
    small_radius = Fraction(r.randint(1, 9), r.choice([1, 2, 3]))
    radius = small_radius + Fraction(r.randint(0, 9), r.choice([1, 2, 3]))
    k = r.randrange(16)
    a, b = Fraction(r.randint(0, 12), 12), Fraction(r.randint(0, 12), 12)

    def on_it(point):
        x, y, z = point
        R, s = q(radius), q(small_radius)
        return (x * x + y * y + z * z + R * R - s * s) ** 2 == 4 * R * R * (x * x + y * y)

    # Piece i + 4 j or j + 4 i lies over unit squares: the parameters go from 0 to 4 both ways.
    i, j = k % 4, k // 4
    pieces = f"torus({written(radius)}, {written(small_radius)})"
    return f"(s -> extended(s, {written(i + a)}, {written(j + b)}))({pieces}[{k}])", on_it


@kind
def revolve(r):
    points = [[abs(small(r)) + 1, small(r)] for _ in range(r.randint(2, 4))]
    k, a, b = r.randrange(4), Fraction(r.randint(0, 6), 6), Fraction(r.randint(0, 6), 6)
    x, z = casteljau(points, b)
    wanted = lambda value: value[2] == q(z) and value[0] ** 2 + value[1] ** 2 == q(x * x)
    return f"(s -> extended(s, {written(k + a)}, {written(b)}))(revolve({bezier_of(points)})[{k}])", wanted


@kind
def compose_surface(r):
    d = r.choice([1, 3])
    m, n = r.randint(1, 3), r.randint(1, 3)
    net = [some_points(r, n + 1, d, 3) for _ in range(m + 1)]
    inner = [numbers(r, r.randint(1, 3), 3) for _ in range(2)]
    inner[0] += [Fraction(1)]
    t = small(r)
    u, v = value(inner[0], t), value(inner[1], t)
    rows = [casteljau(row, v) for row in net]
    wanted = casteljau(rows, u)
    patch = f"patch({net_of(net)})" if d == 3 else f"patch({net_of([[p[0] for p in row] for row in net])})"
    formulas = ", ".join(base.polynomial(p) for p in inner)
    wanted = same(wanted) if d == 3 else q(wanted[0])
    return f"extended(compose({patch}, [{formulas}]), {written(t)})", wanted


@kind
def compose_patch(r):
    m, n = r.randint(1, 2), r.randint(1, 2)
    net = [some_points(r, n + 1, 3, 3) for _ in range(m + 1)]
    inner = [some_points(r, 2, 2, 3) for _ in range(r.randint(2, 3))]
    s, t = small(r), small(r)
    u, v = casteljau([casteljau(row, t) for row in inner], s)
    wanted = casteljau([casteljau(row, v) for row in net], u)
    return (
        f"extended(compose(patch({net_of(net)}), patch({net_of(inner)})), {written(s)}, {written(t)})",
        same(wanted),
    )


# ---- triangles ------------------------------------------------------------------------------------------------------

QUADRATIC = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]


def monomials(p, degree, i=0, j=0):
    """∂_x^i ∂_y^j of all monomials of total degree at most d at a point."""
    found = []
    for total in range(degree + 1):
        for b in range(total + 1):
            a = total - b
            if a < i or b < j:
                found.append(Fraction(0))
                continue
            scale = factorial(a) // factorial(a - i) * (factorial(b) // factorial(b - j))
            found.append(scale * p[0] ** (a - i) * p[1] ** (b - j))
    return found


def triangle(r):
    while True:
        p = some_points(r, 3, 2)
        if (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) != (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]):
            return p


def mixed(points, weights):
    return [sum((w * p[k] for w, p in zip(weights, points)), Fraction(0)) for k in range(2)]


def piecewise_element(r, corners, pieces, degree, data):
    """The piecewise polynomial over pieces of a triangle that is C^1, with conditions (piece, row of derivatives, value)."""
    size = (degree + 1) * (degree + 2) // 2
    rows, right = [], []
    for i, a in enumerate(pieces):
        for j in range(i):
            shared = [p for p in a if p in pieces[j]]
            if len(shared) < 2:
                continue
            for k in range(degree + 1):
                p = mixed(shared, [1 - Fraction(k, degree), Fraction(k, degree)])
                for order in [(0, 0), (1, 0), (0, 1)]:
                    row = [Fraction(0)] * (size * len(pieces))
                    list_ = monomials(p, degree, *order)
                    row[i * size : (i + 1) * size] = list_
                    row[j * size : (j + 1) * size] = [-x for x in list_]
                    rows.append(row)
                    right.append(Fraction(0))
    for piece, list_, wanted in data:
        row = [Fraction(0)] * (size * len(pieces))
        row[piece * size : (piece + 1) * size] = list_
        rows.append(row)
        right.append(wanted)
    matrix = fmpq_mat([[q(x) for x in row] + [q(y)] for row, y in zip(rows, right)])
    reduced, rank = matrix.rref()
    if rank != size * len(pieces):
        return None
    return [Fraction(int(reduced[i, rank].p), int(reduced[i, rank].q)) for i in range(rank)]


def element(r, kind_):
    corners = triangle(r)
    data = [numbers(r, 3) for _ in range(3)]
    centre = mixed(corners, [Fraction(1, 3)] * 3)
    conditions = []
    if kind_ == "powell_sabin":
        degree, pieces = 2, []
        for i in range(3):
            p, n = corners[i], corners[(i + 1) % 3]
            middle = mixed([p, n], [Fraction(1, 2)] * 2)
            pieces += [[p, middle, centre], [middle, n, centre]]
        owner = [0, 2, 4]
        extra = ""
    else:
        degree, pieces = 3, [[corners[i], corners[(i + 1) % 3], centre] for i in range(3)]
        owner = [0, 1, 2]
        slopes = numbers(r, 3)
        extra = f", normals={in_list(slopes)}"
        for i, wanted in enumerate(slopes):
            a, b = corners[i], corners[(i + 1) % 3]
            middle = mixed([a, b], [Fraction(1, 2)] * 2)
            x, y = monomials(middle, degree, 1, 0), monomials(middle, degree, 0, 1)
            row = [-(b[1] - a[1]) * s + (b[0] - a[0]) * t for s, t in zip(x, y)]
            conditions.append((i, row, wanted))
    for i, list_ in enumerate(data):
        for order, wanted in zip([(0, 0), (1, 0), (0, 1)], list_):
            conditions.append((owner[i], monomials(corners[i], degree, *order), wanted))
    found = piecewise_element(r, corners, pieces, degree, conditions)
    if found is None:
        return None
    k = r.randrange(len(pieces))
    weights = [Fraction(r.randint(0, 5) + 1) for _ in range(3)]
    weights = [w / sum(weights) for w in weights]
    p = mixed(pieces[k], weights)
    size = (degree + 1) * (degree + 2) // 2
    wanted = sum((c * x for c, x in zip(found[k * size : (k + 1) * size], monomials(p, degree))), Fraction(0))
    made = f"{kind_}({points_of(corners)}, {points_of(data)}{extra})"
    return f"(s -> s({in_list(p)}))({made}[{k}])", q(wanted)


@kind
def powell_sabin(r):
    return element(r, "powell_sabin")


@kind
def clough_tocher(r):
    return element(r, "clough_tocher")


@kind
def spline_dimension(r):
    """Triangles around a vertex or in a strip; the rank of the conditions of smoothness."""
    if r.random() < 0.6:
        directions = [(3, 0), (2, 1), (1, 1), (1, 3), (0, 2), (-1, 2), (-2, 2), (-3, 1), (-2, 0), (-3, -2), (-1, -1), (-1, -3), (0, -1), (1, -2), (3, -3), (3, -1)]
        count = r.randint(3, 6)
        chosen = sorted(r.sample(range(len(directions)), count))
        outer = [directions[k] for k in chosen]
        turn = lambda a, b: a[0] * b[1] - a[1] * b[0]
        closed = all(turn(a, b) > 0 for a, b in zip(outer, outer[1:] + outer[:1]))
        if not all(turn(a, b) > 0 for a, b in zip(outer, outer[1:])):
            return None
        points = [(0, 0)] + outer
        triangles = [[0, i, i + 1] for i in range(1, count)] + ([[0, count, 1]] if closed else [])
    else:
        count = r.randint(3, 6)
        points = [(2 * k + r.randint(0, 1), (k % 2) * 3 + r.randint(-1, 1)) for k in range(count)]
        triangles = [[k, k + 1, k + 2] for k in range(count - 2)]
        area = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if any(area(*[points[i] for i in t]) == 0 for t in triangles):
            return None
    degree, smooth = r.randint(1, 4), r.randint(0, 2)
    size = (degree + 1) * (degree + 2) // 2
    rows = []
    for i, a in enumerate(triangles):
        for j in range(i):
            shared = [p for p in a if p in triangles[j]]
            if len(shared) < 2:
                continue
            ends = [[Fraction(x) for x in points[k]] for k in shared]
            for k in range(degree + 1):
                p = mixed(ends, [1 - Fraction(k, degree), Fraction(k, degree)])
                for total in range(smooth + 1):
                    for b in range(total + 1):
                        list_ = monomials(p, degree, total - b, b)
                        row = [Fraction(0)] * (size * len(triangles))
                        row[i * size : (i + 1) * size] = list_
                        row[j * size : (j + 1) * size] = [-x for x in list_]
                        rows.append(row)
    rank = fmpq_mat([[q(x) for x in row] for row in rows]).rank() if rows else 0
    lists = "[" + ", ".join("[" + ", ".join(map(str, t)) + "]" for t in triangles) + "]"
    corners = points_of([[Fraction(x) for x in p] for p in points])
    return f"spline_dimension({corners}, {lists}, {degree}, {smooth})", fmpq(size * len(triangles) - rank)


# ---- equations ------------------------------------------------------------------------------------------------------


def on(p, coordinates):
    """A polynomial in x, y, z at fractions."""
    x = [q(c) for c in coordinates]
    if not isinstance(p, flint.fmpq_mpoly):
        return p
    values = {"x": x[0], "y": x[1], "z": x[2] if len(x) > 2 else fmpq(0), "t": fmpq(0), "u": fmpq(0)}
    return p(*[values[name] for name in base.NAMES])


def is_prime(p):
    return isinstance(p, flint.fmpq_mpoly) and [k for _, k in p.factor()[1]] == [1]


@kind
def implicit(r):
    lists = [numbers(r, r.randint(1, 4), 4) for _ in range(2)]
    weight = numbers(r, r.randint(1, 3), 3)
    if not any(weight[1:]):
        weight = [Fraction(1)]
    if all(not any(p[1:]) for p in lists):
        return None
    shown = base.polynomial(weight)

    def right(found):
        places = [t for t in (Fraction(k, 3) for k in range(-12, 40)) if value(weight, t)]
        zero = all(on(found, [value(p, t) / value(weight, t) for p in lists]) == 0 for t in places)
        return is_prime(found) and zero

    if not any(times_minus(lists[0], weight, lists[1])):
        return None
    return f"implicit([({base.polynomial(lists[0])})/({shown}) , ({base.polynomial(lists[1])})/({shown})])", right


def times_minus(p, weight, other):
    """Something that is 0 if both quotients are numbers."""
    return plus(times(slope(p), weight), times(p, slope(weight)), -1) + plus(
        times(slope(other), weight), times(other, slope(weight)), -1
    )


@kind
def implicit_space(r):
    lists = [integers(r, r.randint(1, 4)) for _ in range(3)]
    if all(not any(p[1:]) for p in lists):
        return None

    def right(found):
        places = [[value(p, Fraction(k, 2)) for p in lists] for k in range(-10, 11)]
        return len(found) >= 2 and all(on(p, place) == 0 for p in found for place in places)

    return f"implicit([{', '.join(base.polynomial(p) + ' + 0 t' for p in lists)}])", right


@kind
def implicit_surface(r):
    monomial = r.choice([[(0, 0), (1, 0), (0, 1), (1, 1)], [(0, 0), (1, 0), (0, 1), (2, 0)], [(1, 0), (0, 1), (2, 0), (0, 2)]])
    lists = [{m: Fraction(r.randint(-3, 3)) for m in monomial} for _ in range(3)]
    u, v = Fraction(5, 7), Fraction(-3, 11)

    def derivative(p, k):
        found = {}
        for (i, j), c in p.items():
            if (i, j)[k]:
                found[(i - (k == 0), j - (k == 1))] = c * (i, j)[k]
        return found

    rows = [[value_in_two(derivative(p, k), u, v) for p in lists] for k in range(2)]
    if fmpq_mat([[q(x) for x in row] for row in rows]).rank() < 2:
        return None

    def right(found):
        places = [[value_in_two(p, Fraction(i), Fraction(j, 2)) for p in lists] for i in range(-3, 4) for j in range(-3, 4)]
        return is_prime(found) and all(on(found, place) == 0 for place in places)

    return f"implicit_surface([{', '.join(two(p) for p in lists)}])", right


@kind
def intersection_curve(r):
    lists = [{(i, j): small(r, 3) for i in range(2) for j in range(2)} for _ in range(3)]
    plane = numbers(r, 4, 3)
    wanted = collections.defaultdict(Fraction)
    for p, c in zip(lists, plane):
        for m, x in p.items():
            wanted[m] += c * x
    wanted[0, 0] += plane[3]
    if not any(c for m, c in wanted.items() if m != (0, 0)):
        return None
    shown = " + ".join(f"({written(c)}) {name}" for c, name in zip(plane, "xyz")) + f" + ({written(plane[3])})"
    # x and y for u and v, which FLINT knows here; both occur.
    query = f"subs(intersection_curve([{', '.join(two(p) for p in lists)}], {shown}) + 1000 u v, u=x, v=y)"
    if not any(plane[:3]):
        return None

    def right(found):
        # Proportional.
        (a, b) = (Fraction(2, 3), Fraction(5, 7))
        found = found - 1000 * base.GENERATORS["x"] * base.GENERATORS["y"]
        first = on(found, [a, b]), value_in_two(wanted, a, b)
        grid = [(Fraction(i), Fraction(j, 3)) for i in range(-2, 3) for j in range(-2, 3)]
        return all(on(found, [x, y]) * q(first[1]) == q(value_in_two(wanted, x, y)) * first[0] for x, y in grid)

    return query, right


@kind
def space_intersections(r):
    """Two curves that meet at planted parameters; all pairs that are rational are common points."""
    a = [integers(r, 3) for _ in range(3)]
    b = [integers(r, r.randint(2, 3)) for _ in range(3)]
    s, t = Fraction(r.randint(-3, 3)), Fraction(r.randint(-3, 3))
    for p, other in zip(a, b):
        other[0] += value(p, s) - value(other, t)
    if all(not any(p[1:]) for p in a) or all(not any(p[1:]) for p in b):
        return None
    # The same points twice: one curve runs on the other.
    grid = [[value(p, Fraction(k, 7)) for p in a] for k in range(-40, 41)]
    if fmpq_mat([[q(x) for x in list_] for list_ in [p[1:] + [Fraction(0)] * 2 for p in a]]).rank() < 2:
        return None
    first, second = (", ".join(base.polynomial(p) + " + 0 t" for p in list_) for list_ in (a, b))

    return f"intersections([{first}], [{second}])", (a, b, s, t)


# ---- blossoms -------------------------------------------------------------------------------------------------------


def function_of(parts, k):
    return " + ".join(f"({written(c)})/({written(a)} - t)^{k}" for a, c in parts)


@kind
def multirational(r):
    m = r.randint(0, 3)
    if r.random() < 0.5:
        k = r.randint(1, 3)
        v = numbers(r, m + k)
        u = numbers(r, m)
        parts = [(Fraction(a), small(r)) for a in r.sample(range(7, 14), r.randint(1, 2))]
        wanted = Fraction(0)
        for a, c in parts:
            product = c
            for x in u:
                product *= a - x
            for x in v:
                product /= a - x
            wanted += product
        if not any(c for _, c in parts):
            return None
        return f"multirational({function_of(parts, k)}, {in_list(u)}, {in_list(v)})", q(wanted)
    # A polynomial: c_k is Σ (−1)^i e_(k−i)(u) h_i(v) over C(d, k), with sums h_i of all products of i of the v, repeated or not.
    order = r.randint(0, 4)
    c = numbers(r, order + 1)
    u, v = numbers(r, order + m), numbers(r, m)
    wanted = Fraction(0)
    for k in range(order + 1):
        part = Fraction(0)
        for i in range(k + 1):
            complete = Fraction(0)
            for chosen in combinations_with_replacement(v, i):
                product = Fraction(1)
                for x in chosen:
                    product *= x
                complete += product
            part += (-1) ** i * elementary(u, k - i) * complete
        wanted += c[k] * part / comb(order, k)
    return f"multirational({base.polynomial(c)} + 0 t, {in_list(u)}, {in_list(v)})", q(wanted)


@kind
def chebyshev_blossom(r):
    n = r.randint(1, 3)
    exponents = sorted(r.sample([-2, -1, 1, 2, 3, 4, 5], n))
    u = [abs(small(r)) + Fraction(k + 1, 5) for k in range(n)]
    if len(set(u)) < n:
        return None
    # Planes det(X − Φ, Φ', …, Φ^(n−1)) = 0.
    jet = lambda x, k: [falling(e, k) * x ** (e - k) for e in exponents]
    rows, right = [], []
    for x in u:
        derivatives = [jet(x, k) for k in range(1, n)]
        normal = []
        for i in range(n):
            unit = [[Fraction(int(i == j)) for j in range(n)]] + derivatives
            det = fmpq_mat([[q(y) for y in row] for row in unit]).det()
            normal.append(Fraction(int(det.p), int(det.q)))
        rows.append(normal)
        right.append(sum(a * b for a, b in zip(normal, jet(x, 0))))
    found = solved(rows, right)
    if found is None:
        return None
    c = numbers(r, n + 1)
    wanted = c[0] + sum(a * b for a, b in zip(c[1:], found))
    power = lambda e: f"t^{e}" if e > 0 else f"1/t^{-e}"
    formula = " + ".join([f"({written(c[0])})"] + [f"({written(a)}) {power(e)}" for a, e in zip(c[1:], exponents)])
    space = "[" + ", ".join(map(power, exponents)) + "]"
    if not any(c[1:]):
        return None
    return f"chebyshev_blossom({formula}, {space}, {', '.join(map(written, u))})", q(wanted)


def falling(e, k):
    found = Fraction(1)
    for i in range(k):
        found *= e - i
    return found


@kind
def multilinear(r):
    n = r.randint(1, 5)
    c = numbers(r, n + 1)
    pairs = [[small(r), r.choice([Fraction(0), Fraction(1), small(r)])] for _ in range(n)]
    wanted = Fraction(0)
    for k in range(n + 1):
        for chosen in combinations(range(n), k):
            product = c[k] / comb(n, k)
            for i, (u, w) in enumerate(pairs):
                product *= u if i in chosen else w
            wanted += product
    return f"multilinear({base.polynomial(c)} + 0 t, {points_of(pairs)})", q(wanted)


@kind
def polar_in_space(r):
    degree = r.randint(1, 3)
    terms = {}
    for _ in range(r.randint(1, 4)):
        e = [r.randint(0, degree) for _ in range(3)]
        if sum(e) <= degree:
            terms[tuple(e)] = small(r)
    if not terms:
        return None
    # f(p_1, …, p_d) of u^i v^j w^k: the mean of products over all ways to share the arguments.
    corners = [[Fraction(0)] * 3, [Fraction(1), Fraction(0), Fraction(1)], [Fraction(0), Fraction(2), Fraction(0)], [Fraction(1), Fraction(1), Fraction(-1)]]
    pick = [r.randrange(4) for _ in range(degree)]
    arguments = [corners[i] for i in pick]
    total = Fraction(0)
    for e, c in terms.items():
        slots = [axis for axis, k in enumerate(e) for _ in range(k)]
        ways = list(permutations(range(degree), len(slots)))
        part = Fraction(0)
        for way in ways:
            product = Fraction(1)
            for axis, place in zip(slots, way):
                product *= arguments[place][axis]
            part += product
        total += c * part / len(ways)
    formula = " + ".join(f"({written(c)}) u^{i} v^{j} w^{k}" for (i, j, k), c in terms.items())
    return (
        f"polar_total({formula}, [u, v, w], degree={degree})({', '.join('(' + ', '.join(map(written, p)) + ')' for p in arguments)})",
        q(total),
    )


# ---- splines and integrals ------------------------------------------------------------------------------------------


def clamped(r, n, inner):
    inside = r.increasing(inner + 2, 6)
    return [inside[0]] * (n + 1) + inside[1:-1] + [inside[-1]] * (n + 1)


@kind
def basis_at_knots(r):
    """Values at breakpoints and between them, also where knots follow a repeated end of the domain."""
    n = r.randint(0, 4)
    knots, k = [], 0
    while len(knots) < 2 * n + 4 or r.random() < 0.4:
        knots += [Fraction(k)] * r.choice([1, 1, 2, n + 1] if n else [1])
        k += r.randint(1, 3)
    m = len(knots) - n - 1
    a, b = knots[n], knots[m]
    if m <= n or a == b or any(knots.count(x) > n + 1 for x in knots):
        return None
    t = r.choice([x for x in knots if a <= x <= b] + [a + (b - a) * Fraction(r.randint(0, 7), 7)])
    i = r.randrange(m)
    if r.random() < 0.5:
        return f"bspline_basis({n}, {in_list(knots)}, {i})({written(t)})", q(cox(knots, i, n, t, b))
    d = numbers(r, m)
    wanted = sum((c * cox(knots, i, n, t, b) for i, c in enumerate(d)), Fraction(0))
    return f"bspline({n}, {in_list(knots)}, {in_list(d)})({written(t)})", q(wanted)


@kind
def gram(r):
    n = r.randint(1, 3)
    knots = clamped(r, n, r.randint(0, 3))
    m = len(knots) - n - 1
    i, j = r.randrange(m), r.randrange(m)
    wanted = Fraction(0)
    for a, b in zip(knots, knots[1:]):
        if a != b:
            wanted += integral(lambda t: cox(knots, i, n, t, b) * cox(knots, j, n, t, b), a, b, 2 * n)
    return f"gram({n}, {in_list(knots)})", lambda matrix: matrix[i][j] == q(wanted)


@kind
def energy(r):
    points = some_points(r, r.randint(2, 5), r.randint(1, 3))
    k = r.randint(0, len(points) - 1)
    wanted = Fraction(0)
    for list_ in powers(points):
        for _ in range(k):
            list_ = slope(list_)
        wanted += integral(lambda t: value(list_, t) ** 2, Fraction(0), Fraction(1), 2 * len(points))
    shown = points if len(points[0]) > 1 else [p[0] for p in points]
    return f"energy({bezier_of(shown)}, {k})", q(wanted)


@kind
def squared_distance(r):
    d = r.randint(2, 3)
    a, b = some_points(r, r.randint(2, 5), d), some_points(r, r.randint(2, 5), d)
    wanted = Fraction(0)
    for p, o in zip(powers(a), powers(b)):
        difference = plus(p, o, -1)
        wanted += integral(lambda t: value(difference, t) ** 2, Fraction(0), Fraction(1), 2 * len(difference))
    return f"squared_distance({bezier_of(a)}, {bezier_of(b)})", q(wanted)


@kind
def best_reduction(r):
    points = some_points(r, r.randint(3, 6), 2)
    k = r.randint(1, len(points) - 2)
    n = len(points) - 1 - k

    def right(found):
        for axis, list_ in enumerate(powers(points)):
            mine = [[Fraction(int(p[axis].p), int(p[axis].q))] for p in found]
            rest = plus(list_, powers(mine)[0], -1)
            moments = [integral(lambda t: value(rest, t) * t**j, Fraction(0), Fraction(1), len(points) + j) for j in range(n + 1)]
            if any(moments) or len(found) != n + 1:
                return False
        return True

    return f"control_points(best_reduction({bezier_of(points)}, {k}))", right


@kind
def dual_basis(r):
    n = r.randint(0, 5)
    a = small(r)
    b = a + 1 + abs(small(r))
    i, j = r.randint(0, n), r.randint(0, n)
    bernstein = lambda t: comb(n, j) * ((t - a) / (b - a)) ** j * ((b - t) / (b - a)) ** (n - j)

    def right(found):
        p = found[i]

        def at_(t):
            x = on_t(p, t)
            return Fraction(int(x.p), int(x.q))

        return integral(lambda t: at_(t) * bernstein(t), a, b, 2 * n) == int(i == j)

    return f"dual_basis({n}, [bernstein, {written(a)}, {written(b)}])", right


def on_t(p, t):
    if not isinstance(p, flint.fmpq_mpoly):
        return fmpq(p)
    return p(*[q(t) if name == "t" else fmpq(0) for name in base.NAMES])


@kind
def deboor_fix(r):
    n = r.randint(1, 4)
    knots = clamped(r, n, r.randint(0, 3))
    m = len(knots) - n - 1
    c = numbers(r, n + 1)
    i = r.randrange(m)
    low, high = knots[i], knots[i + n + 1]
    tau = low + (high - low) * Fraction(r.randint(1, 10), 11)
    wanted = power_form(c, knots[i + 1 : i + n + 1])
    return f"deboor_fix({base.polynomial(c)} + 0 t, {n}, {in_list(knots)}, {i}, {written(tau)})", q(wanted)


@kind
def schoenberg(r):
    n = r.randint(1, 4)
    knots = clamped(r, n, r.randint(0, 4))
    m = len(knots) - n - 1
    c = numbers(r, r.randint(1, 5))
    wanted = [value(c, sum(knots[i + 1 : i + n + 1]) / n) for i in range(m)]
    return f"control_points(schoenberg({base.polynomial(c)} + 0 t, {n}, {in_list(knots)}))", same(wanted)


@kind
def interpolating_spline(r):
    n = r.randint(1, 4)
    knots = clamped(r, n, r.randint(0, 4))
    m = len(knots) - n - 1
    end = knots[-1]
    nodes = []
    for i in range(m):
        low = max(knots[i], nodes[-1] if nodes else knots[i])
        nodes.append(low + (knots[i + n + 1] - low) * Fraction(r.randint(1, 4), 11))
    if r.random() < 0.5:
        nodes[0], nodes[-1] = knots[0], end
    if sorted(set(nodes)) != nodes:
        return None
    rows = [[cox(knots, i, n, x, end) for i in range(m)] for x in nodes]
    y = numbers(r, len(nodes))
    d = solved(rows, y)
    if d is None:
        return None
    t = knots[0] + (end - knots[0]) * Fraction(r.randint(0, 20), 20)
    wanted = sum(c * cox(knots, i, n, t, end) for i, c in enumerate(d))
    return f"interpolating_spline({n}, {in_list(nodes)}, {in_list(y)}, knots={in_list(knots)})({written(t)})", q(wanted)


@kind
def least_squares_spline(r):
    n = r.randint(1, 3)
    knots = clamped(r, n, r.randint(0, 2))
    m = len(knots) - n - 1
    end = knots[-1]
    nodes = [knots[0] + (end - knots[0]) * Fraction(k, m + 3) for k in range(m + 4)]
    y = numbers(r, len(nodes))
    weights = [abs(small(r)) + 1 for _ in nodes]
    a = [[cox(knots, i, n, x, end) for i in range(m)] for x in nodes]
    rows = [[sum(w * row[i] * row[j] for w, row in zip(weights, a)) for j in range(m)] for i in range(m)]
    d = solved(rows, [sum(w * row[i] * z for w, row, z in zip(weights, a, y)) for i in range(m)])
    if d is None:
        return None
    query = f"least_squares_spline({n}, {in_list(knots)}, {in_list(nodes)}, {in_list(y)}, weights={in_list(weights)})"
    return f"control_points({query})", same(d)


@kind
def refine(r):
    n = r.randint(1, 4)
    knots = clamped(r, n, r.randint(0, 3))
    m = len(knots) - n - 1
    points = some_points(r, m, 2)
    finer = sorted(knots + [k for k in r.increasing(r.randint(1, 4), 6) if knots[0] < k < knots[-1] and k not in knots])
    wanted = []
    for i in range(len(finer) - n - 1):
        # Any interval of the old knots that the new function meets.
        inside = next(x for x in range(i, i + n + 1) if finer[x] != finer[x + 1])
        middle = (finer[inside] + finer[inside + 1]) / 2
        j = max(k for k, x in enumerate(knots) if x <= middle)
        wanted.append(same(blossom(knots, points, n, j, finer[i + 1 : i + n + 1])))
    return f"control_points(refine(bspline({n}, {in_list(knots)}, {points_of(points)}), {in_list(finer)}))", wanted


@kind
def rational_spline_derivatives(r):
    n = r.randint(1, 3)
    knots = clamped(r, n, r.randint(0, 3))
    m = len(knots) - n - 1
    points, weights = some_points(r, m, 2), [abs(small(r)) + 1 for _ in range(m)]
    lifted = [[w * x for x in p] + [w] for p, w in zip(points, weights)]
    t = knots[0] + (knots[-1] - knots[0]) * Fraction(r.randint(1, 22), 23)
    j = max(k for k, x in enumerate(knots) if x <= t)
    # The piece by powers of (s − t): polar values with vectors are differences.
    jet = []
    for k in range(3):
        if k > n:
            jet.append([Fraction(0)] * 3)
            continue
        total = [Fraction(0)] * 3
        for subset in range(k + 1):
            sign = (-1) ** (k - subset) * comb(k, subset)
            part = blossom(knots, lifted, n, j, [t + 1] * subset + [t] * (n - subset))
            total = [a + sign * b for a, b in zip(total, part)]
        jet.append([factorial(n) // factorial(n - k) * x for x in total])
    (x0, y0, w0), (x1, y1, w1), (x2, y2, w2) = jet
    found = []
    for a0, a1, a2 in ((x0, x1, x2), (y0, y1, y2)):
        f0 = a0 / w0
        f1 = (a1 - f0 * w1) / w0
        found.append([f0, f1, (a2 - 2 * f1 * w1 - f0 * w2) / w0])
    wanted = [same([found[0][k], found[1][k]]) for k in range(3)]
    return f"derivatives_at(bspline({n}, {in_list(knots)}, {points_of(points)}, weights={in_list(weights)}), {written(t)}, 2)", wanted


@kind
def spline_sum(r):
    n = r.randint(1, 3)
    lists = []
    ends = r.increasing(2, 6)
    for _ in range(2):
        inner = sorted({ends[0] + (ends[1] - ends[0]) * Fraction(r.randint(1, 5), 6) for _ in range(r.randint(0, 3))})
        knots = [ends[0]] * (n + 1) + inner + [ends[1]] * (n + 1)
        lists.append((knots, numbers(r, len(knots) - n - 1)))
    t = ends[0] + (ends[1] - ends[0]) * Fraction(r.randint(0, 24), 24)
    wanted = sum(c * cox(k, i, n, t, k[-1]) for k, d in lists for i, c in enumerate(d))
    shown = " + ".join(f"bspline({n}, {in_list(k)}, {in_list(d)})" for k, d in lists)
    return f"({shown})({written(t)})", q(wanted)


# ---- differential geometry ------------------------------------------------------------------------------------------


def jet_of(points, t, count):
    lists = powers(points)
    found = []
    for _ in range(count):
        found.append([value(p, t) for p in lists])
        lists = [slope(p) for p in lists]
    return found


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


@kind
def squared_curvature(r):
    points, t = some_points(r, r.randint(3, 5), r.choice([2, 3])), Fraction(r.randint(0, 10), 10)
    _, a, b = jet_of(points, t, 3)
    if not any(a):
        return None
    wanted = (dot(a, a) * dot(b, b) - dot(a, b) ** 2) / dot(a, a) ** 3
    return f"squared_curvature({bezier_of(points)}, {written(t)})", q(wanted)


@kind
def torsion(r):
    points, t = some_points(r, r.randint(4, 5), 3), Fraction(r.randint(0, 10), 10)
    _, a, b, c = jet_of(points, t, 4)
    normal = cross(a, b)
    if not any(normal):
        return None
    return f"torsion({bezier_of(points)}, {written(t)})", q(dot(normal, c) / dot(normal, normal))


@kind
def centroid(r):
    points = some_points(r, 4, 2)
    line = [points[3], points[0]]
    area = mx = my = Fraction(0)
    for curve in (points, line):
        x, y = powers(curve)
        dx, dy = slope(x), slope(y)
        whole = lambda p: integral(lambda t: value(p, t), Fraction(0), Fraction(1), len(p))
        area += whole(plus(times(x, dy), times(y, dx), -1)) / 2
        mx += whole(times(times(x, x), dy)) / 2
        my -= whole(times(times(y, y), dx)) / 2
    if area == 0:
        return None
    return f"centroid([{bezier_of(points)}, {bezier_of(line)}])", same([mx / area, my / area])


@kind
def characteristic_polynomial(r):
    n = r.randint(2, 6)
    rows = [numbers(r, n) for _ in range(n)]
    wanted = base.lifted(fmpq_mat([[q(x) for x in row] for row in rows]).charpoly())
    matrix = "[" + "; ".join(", ".join(map(written, row)) for row in rows) + "]"
    return f"characteristic_polynomial({matrix}, variable=t)", wanted


@kind
def limit_points(r):
    """Splines over the integers: limits of p_i are sums of values of basis functions at them."""
    n = r.choice([1, 2, 3, 4, 5])
    m = r.randint(3, 7)
    points = some_points(r, m, 2)
    knots = [Fraction(k) for k in range(n + 2)]
    # Old vertices stand at integers for odd degrees, in the middle between them for even ones.
    shift = Fraction(n + 1, 2) if n % 2 else Fraction(n, 2)
    wanted = []
    for i in range(m):
        total = [Fraction(0)] * 2
        for k in range(-n - 1, n + 2):
            weight = cox(knots, 0, n, shift - k, Fraction(-100)) if 0 <= shift - k < n + 1 else Fraction(0)
            total = [a + weight * b for a, b in zip(total, points[(i + k) % m])]
        wanted.append(same(total))
    return f"limit_points({points_of(points)}, [lane_riesenfeld, {n}], closed=1)", wanted


@kind
def solve_planted(r):
    """The solutions of a triangular system."""
    x0, y0 = Fraction(r.randint(-4, 4)), Fraction(r.randint(-4, 4))
    a, b = r.choice([-2, -1, 1, 2]), Fraction(r.randint(-3, 3))
    first = f"{a} (x - ({written(x0)})) (x - ({written(x0 + 1)}))"
    second = f"y - ({written(y0)}) - ({written(b)}) (x - ({written(x0)}))"
    wanted = [same([x0, y0]), same([x0 + 1, y0 + b])]
    return f"solve([{first} = 0, {second} = 0], [x, y])", wanted


@kind
def solve_linear(r):
    n = r.randint(1, 5)
    rows = [[Fraction(r.randint(-5, 5)) for _ in range(n)] for _ in range(n)]
    right = numbers(r, n)
    wanted = solved(rows, right)
    if wanted is None:
        return None
    names = ["x", "y", "z", "t", "u"][:n]
    equations = ", ".join(
        " + ".join(f"({written(c)}) {name}" for c, name in zip(row, names)) + f" = {written(y)}" for row, y in zip(rows, right)
    )
    return f"solve([{equations}], [{', '.join(names)}])", same(wanted)


# ---- running --------------------------------------------------------------------------------------------------------


def overlap(a, b):
    """Whether the differences of coordinates have a common factor, over FLINT."""
    ring = base.RING
    t, u = base.GENERATORS["t"], base.GENERATORS["u"]
    of = lambda p, x: sum((q(c) * x**k for k, c in enumerate(p)), ring.from_dict({}))
    common = ring.from_dict({})
    for p, other in zip(a, b):
        common = common.gcd(of(p, t) - of(other, u))
    return not common.is_constant()


def normal_form(found):
    return base.plain(found)


def agrees(text, expected):
    if isinstance(expected, Lines):
        return bool(expected.right(text))
    if isinstance(expected, tuple):
        # Rows of a table, of which those with numbers are common points, and the planted parameters are among them.
        a, b, s, t = expected
        if isinstance(text, str):
            return text == "error: infinitely many, or none" and overlap(a, b)
        pairs = [row.split()[:2] for row in text[1:] if "root_of" not in row]
        pairs = [tuple(map(Fraction, pair)) for pair in pairs]
        return (s, t) in pairs and all([value(p, x) for p in a] == [value(p, y) for p in b] for x, y in pairs)
    if text.startswith("error"):
        return False
    if isinstance(expected, types.FunctionType):
        return bool(expected(value_of(text)))
    return normal_form(value_of(text)) == normal_form(expected)


class Lines:
    """An answer that is looked at line by line, as it is printed."""

    def __init__(self, right):
        self.right = right


def main(kinds=KINDS):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--each", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=sorted(kinds))
    parser.add_argument("--program", default="target/release/polarform")
    options = parser.parse_args()
    failures = 0
    for name in [options.only] if options.only else kinds:
        r = Draw(f"{options.seed} {name}")
        begun, differ = time.time(), 0
        # Different ones; where there are fewer the draws end.
        found = {}
        for _ in range(40 * options.each):
            case = kinds[name](r)
            if case is not None:
                found.setdefault(case[0], case)
            if len(found) == options.each:
                break
        cases = list(found.values())
        for start in range(0, len(cases), 100):
            batch = cases[start : start + 100]
            texts = tables(options.program, batch) if isinstance(batch[0][1], (tuple, Lines)) else answers(options.program, [c[0] for c in batch])
            for (query, expected), text in zip(batch, texts):
                try:
                    right = agrees(text, expected)
                except Exception as error:
                    right, text = False, f"{text}   ({type(error).__name__}: {error})"
                if not right:
                    differ += 1
                    if differ <= 5:
                        print(f"DIFFERS, {name}: {query}\n  polarform: {text}\n  expected:  {expected}", flush=True)
        failures += differ
        print(f"{name}: {len(cases)} cases, {differ} differ, {time.time() - begun:.0f} s", flush=True)
    sys.exit(1 if failures else 0)


def tables(program, batch):
    """The rows of tables, for each query one list, by a mark between them."""
    queries = [query for case in batch for query in (case[0], '"@@"')]
    ran = subprocess.run(
        [program, "--timeout", "20", "--color", "never", "run", "-"], input="\n".join(queries), capture_output=True, text=True
    )
    parts = ran.stdout.split("@@")[:-1]
    clean = [part.strip().strip('"').strip() for part in parts]
    return [part.splitlines() if part else "error: infinitely many, or none" for part in clean]


if __name__ == "__main__":
    main()

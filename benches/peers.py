#!/usr/bin/env python3
"""polarform beside python-flint, PARI (cypari), SymPy and Symbolica: the table of docs/benchmarks.md.

    python3 -m venv venv && venv/bin/pip install python-flint cypari sympy symbolica
    venv/bin/python benches/peers.py

Each figure is the least CPU time of a run, of several runs in each of several fresh processes, ours and
the peers' in turn, on the same inputs (benches/inputs, benches/peers.rs). All checksums must agree.
"""
import json, subprocess, sys, time
from fractions import Fraction
from math import comb, factorial, gcd, lcm

P = (1 << 61) - 1
sys.set_int_max_str_digits(0)
ROUNDS = 2
LIMIT = 60  # seconds for one process


class Lcg:
    def __init__(self, seed):
        self.state = seed

    def draw(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % (1 << 64)
        return self.state >> 32

    def below(self, bound):
        return self.draw() % bound

    def num(self, bound):
        size = self.below(bound) + 1
        return -size if self.below(2) else size

    def rat(self, num, den):
        p = self.num(num)
        return Fraction(p, self.below(den) + 1)

    def bigrat(self, bits, den):
        words = -(-bits // 32)
        size = 0
        for _ in range(words):
            size = size << 32 | self.draw()
        size >>= 32 * words - bits
        size = size or 1 if bits == 64 else size | 1 << (bits - 1)
        size = -size if self.below(2) else size
        return Fraction(size, self.below(den) + 1)


def modp(q):
    q = Fraction(int(q.numerator), int(q.denominator))
    return q.numerator * pow(q.denominator, -1, P) % P


def residues(values):
    h = 0
    for v in values:
        h = (h * 1000033 + v) % P
    return h


def ck_list(values):
    return residues(map(modp, values))


def ck_poly(coefficients):
    h = 0
    for c in reversed(coefficients):
        h = (h * 1000003 + modp(c)) % P
    return h


def ck_terms(terms):
    """The value of {exponents: coefficient} at x = 1001003, y = 1002003, …"""
    points = [1000003 + 1000 * i for i in range(1, 5)]
    total = 0
    for exponents, c in terms:
        term = modp(c)
        for x, e in zip(points, exponents):
            term = term * pow(x, e, P) % P
        total = (total + term) % P
    return total


def in_gcd(v, n, degree):
    lcg = Lcg(1000 + 100 * v + n)

    def one():
        terms = {}
        for _ in range(n):
            e = tuple(lcg.below(degree) for _ in range(v))
            terms[e] = terms.get(e, 0) + lcg.num(100)
        return {e: c for e, c in terms.items() if c}

    return one(), one(), one()


def times(a, b):
    terms = {}
    for e, c in a.items():
        for f, d in b.items():
            k = tuple(x + y for x, y in zip(e, f))
            terms[k] = terms.get(k, 0) + c * d
    return {e: c for e, c in terms.items() if c}


def primitive(terms):
    terms = [(tuple(e), int(c)) for e, c in terms]
    content = 0
    for _, c in terms:
        content = gcd(content, c)
    sign = 1 if max(terms)[1] > 0 else -1
    return [(e, sign * c // content) for e, c in terms]


def system(n):
    lcg = Lcg(3000 + n)
    return [[lcg.num(100) for _ in range(n)] for _ in range(n)], [lcg.num(100) for _ in range(n)]


def a_n(n):
    return [[(-1) ** (k - i) * comb(n, k) * comb(k, i) if i <= k else 0 for i in range(n + 1)] for k in range(n + 1)]


def polynomials(seed, degrees):
    lcg = Lcg(seed)
    return [[lcg.num(100) for _ in range(d + 1)] for d in degrees]


def points(seed, n):
    lcg = Lcg(seed)
    return [(lcg.rat(1000, 1000), lcg.rat(1000, 1000)) for _ in range(n + 1)]


def interpolation(n):
    lcg = Lcg(2000 + n)
    return list(range(n)), [lcg.num(100) for _ in range(n)]


def polar(n):
    lcg = Lcg(300 + n)
    return [lcg.rat(100, 100) for _ in range(n + 1)], [lcg.rat(1000, 1000) for _ in range(n)]


def knots():
    lcg = Lcg(900)
    t = [Fraction(0)]
    while len(t) < 50:
        step = lcg.below(9) + 1
        t.append(t[-1] + Fraction(step, lcg.below(9) + 1))
    return t


def tree(factors):
    while len(factors) > 1:
        factors = [a * b for a, b in zip(factors[::2], factors[1::2])] + factors[len(factors) & ~1 :]
    return factors[0]


def basis(n, t, linear):
    """The recurrence of Cox and de Boor: for each function its polynomials by knot intervals."""
    level = [{i: linear(1, 0)} for i in range(len(t) - 1)]
    for k in range(1, n + 1):
        following = []
        for i in range(len(level) - 1):
            d, e = t[i + k] - t[i], t[i + k + 1] - t[i + 1]
            rise, fall = linear(-t[i] / d, 1 / d), linear(t[i + k + 1] / e, -1 / e)
            pieces = {j: f * rise for j, f in level[i].items()}
            for j, f in level[i + 1].items():
                f = f * fall
                pieces[j] = pieces[j] + f if j in pieces else f
            following.append(pieces)
        level = following
    return [f[j] for f in level for j in sorted(f)]


def identities(count, power="^"):
    """B_i^n = (1 - t) B_i^{n-1} + t B_{i-1}^{n-1}, both sides as text."""
    pairs = [(n, i) for n in range(1, 21) for i in range(n + 1)]
    b = lambda n, i: f"{comb(n, i)}*t{power}{i}*(1-t){power}{n - i}" if 0 <= i <= n else "0"
    pairs = [pairs[k % len(pairs)] for k in range(count)]
    return [(b(n, i), f"(1-t)*({b(n - 1, i)})+t*({b(n - 1, i - 1)})") for n, i in pairs]


# Each gives what is timed and the checksum of its result; None where the peer has no such operation.


def flint(name, sizes):
    import flint as fl

    n = sizes[0]
    q = lambda x: fl.fmpq(x.numerator, x.denominator)
    back = lambda x: Fraction(int(x.p), int(x.q))
    coefficients = lambda f: [back(fl.fmpq(c)) for c in f.coeffs()]
    if name == "integer gcd":
        lcg = Lcg(1)
        pairs = [[fl.fmpz(lcg.bigrat(n, 1).numerator) for _ in range(2)] for _ in range(100)]
        return lambda: [a.gcd(b) for a, b in pairs], lambda r: ck_list([Fraction(int(x)) for x in r])
    if name in ("gcd", "exact division"):
        ctx = fl.fmpz_mpoly_ctx.get(["x", "y", "z", "w"][:n], "lex")
        a, b, c = in_gcd(*sizes)
        x, y, f = (ctx.from_dict(p) for p in (times(a, c), times(b, c), c))
        if name == "gcd":
            return lambda: x.gcd(y), lambda g: ck_terms((e, Fraction(c)) for e, c in primitive(g.to_dict().items()))
        return lambda: x / f, lambda g: ck_terms((e, Fraction(int(c))) for e, c in g.to_dict().items())
    if name == "sparse product":
        ctx = fl.fmpz_mpoly_ctx.get(["x", "y", "z", "w"], "lex")
        x, y = (ctx.from_dict(p) for p in in_gcd(4, n, 100)[:2])
        return lambda: x * y, lambda g: ck_terms((e, Fraction(int(c))) for e, c in g.to_dict().items())
    if name == "polar value":
        f, u = polar(n)
        weights = [fl.fmpq(c.numerator, c.denominator * comb(n, k)) for k, c in enumerate(f)]
        common = fl.fmpz(1)
        for w in weights:
            common = common.lcm(w.q)
        weights = [w.p * (common // w.q) for w in weights]

        def value():
            e = tree([fl.fmpz_poly([x.denominator, x.numerator]) for x in u])
            total = sum((w * e[k] for k, w in enumerate(weights)), fl.fmpz(0))
            return fl.fmpq(total, common * tree([fl.fmpz(x.denominator) for x in u]))

        return value, lambda v: modp(back(v))
    if name == "spline basis":
        t = [q(x) for x in knots()]
        linear = lambda a, b: fl.fmpq_poly([a, b])
        return lambda: basis(n, t, linear), lambda r: residues(ck_poly(coefficients(f)) for f in r)
    if name == "product":
        lcg = Lcg(400 + n)
        f, g = (fl.fmpq_poly([q(lcg.bigrat(64, 16)) for _ in range(n + 1)]) for _ in range(2))
        return lambda: f * g, lambda h: ck_poly(coefficients(h))
    if name == "division":
        f, g = (fl.fmpq_poly(p) for p in polynomials(4000, sizes))
        return lambda: divmod(f, g), lambda r: residues(ck_poly(coefficients(h)) for h in r)
    if name == "gcd in t":
        a, b, c = (fl.fmpq_poly(p) for p in polynomials(5000, 3 * [n]))
        x, y = a * c, b * c
        return lambda: x.gcd(y), lambda g: ck_poly(coefficients(g))
    if name == "elevation":
        rows = list(zip(*points(700, n)))
        raise_by, whole = fl.fmpq_poly([comb(n, k) for k in range(n + 1)]), [comb(2 * n, k) for k in range(2 * n + 1)]
        rows = [[q(x) for x in row] for row in rows]

        def run():
            out = []
            for row in rows:
                h = fl.fmpq_poly([x * comb(n, k) for k, x in enumerate(row)]) * raise_by
                out.append([h[k] / whole[k] for k in range(2 * n + 1)])
            return out

        return run, lambda r: ck_list([back(x) for point in zip(*r) for x in point])
    if name == "subdivision":
        rows = [[q(x) for x in row] for row in zip(*points(701, n))]
        fact = [fl.fmpq(factorial(k)) for k in range(n + 1)]

        def half(row, s):  # Σ_j C(i, j) (1−s)^{i−j} s^j b_j for all i: one product
            left = fl.fmpq_poly([s**j * b / fact[j] for j, b in enumerate(row)])
            right = fl.fmpq_poly([(1 - s) ** j / fact[j] for j in range(n + 1)])
            h = left * right
            return [h[i] * fact[i] for i in range(n + 1)]

        def run():
            s = fl.fmpq(1, 3)
            lefts = [half(row, s) for row in rows]
            rights = [half(row[::-1], 1 - s)[::-1] for row in rows]
            return list(zip(*lefts)) + list(zip(*rights))

        return run, lambda r: ck_list([back(x) for point in r for x in point])
    if name in ("solve", "determinant"):
        a, b = system(n)
        a = fl.fmpz_mat(a)
        if name == "determinant":
            return lambda: a.det(), lambda d: modp(Fraction(int(d)))
        b = fl.fmpz_mat([[x] for x in b])
        return lambda: a.solve(b), lambda x: ck_list([back(fl.fmpq(v)) for v in x.entries()])
    if name == "inverse A_n":
        a = fl.fmpq_mat(fl.fmpz_mat(a_n(n)))
        return lambda: a.inv(), lambda x: ck_list([back(v) for v in x.entries()])


def pari(name, sizes):
    import cypari

    g = cypari.pari
    g.allocatemem(1 << 30)
    n = sizes[0]
    back = lambda x: Fraction(int(x.numerator()), int(x.denominator()))
    row = lambda values: g("[" + ",".join(map(str, values)) + "]")
    poly = lambda c: row(c).Polrev("'t")
    coefficients = lambda f: [back(x) for x in f.Vecrev()]
    formula = lambda p: g("+".join("(%d)*" % c + "*".join("%s^%d" % (v, e) for v, e in zip("xyzw", es)) for es, c in p.items()))
    if name == "integer gcd":
        lcg = Lcg(1)
        pairs = [[g(lcg.bigrat(n, 1).numerator) for _ in range(2)] for _ in range(100)]
        return lambda: [a.gcd(b) for a, b in pairs], lambda r: ck_list([Fraction(int(x)) for x in r])
    if name in ("gcd", "exact division"):
        a, b, c = in_gcd(*sizes)
        x, y, f = formula(times(a, c)), formula(times(b, c)), formula(c)

        def value(h, content):
            h = h / h.content(g(1)) if content else h
            for i, v in enumerate("xyzw"):
                h = h.subst(v, g("Mod(%d,%d)" % (1001003 + 1000 * i, P)))
            return int(h.lift())

        if name == "gcd":
            return lambda: x.gcd(y), lambda h: min(value(h, True), P - value(h, True))  # sign not fixed
        return lambda: x / f, lambda h: value(h, False)
    if name == "product":
        lcg = Lcg(400 + n)
        f, h = (poly([lcg.bigrat(64, 16) for _ in range(n + 1)]) for _ in range(2))
        return lambda: f * h, lambda r: ck_poly(coefficients(r))
    if name == "division":
        f, h = (poly(p) for p in polynomials(4000, sizes))
        return lambda: f.divrem(h), lambda r: residues(ck_poly(coefficients(x)) for x in r)
    if name == "gcd in t":
        a, b, c = (poly(p) for p in polynomials(5000, 3 * [n]))
        x, y = a * c, b * c
        return lambda: x.gcd(y), lambda h: ck_poly(coefficients(h / h.pollead()))
    if name == "polar value":
        f, u = polar(n)
        value = g("(a, u) -> my(n = #u, D = vecprod([denominator(c) | c <- u]),"
                  "e = Vecrev(vecprod([denominator(c) + numerator(c) * 'x | c <- u]), n + 1));"
                  "sum(k = 0, n, a[k + 1] * e[k + 1] / binomial(n, k)) / D")
        f, u = row(f), row(u)
        return lambda: value(f, u), lambda v: modp(back(v))
    if name == "identities":
        texts = identities(n)
        return lambda: sum(bool(g(l) == g(r)) for l, r in texts), int
    if name == "interpolation":
        nodes, values = (row(r) for r in interpolation(n))
        through = g("(nodes, values) -> polinterpolate(nodes, values)")
        return lambda: through(nodes, values), lambda r: ck_list((coefficients(r) + n * [Fraction(0)])[:n])
    if name in ("solve", "determinant"):
        a, b = system(n)
        a = g("[" + ";".join(",".join(map(str, r)) for r in a) + "]")
        if name == "determinant":
            return lambda: a.matdet(), lambda d: modp(Fraction(int(d)))
        b = g("[" + ";".join(map(str, b)) + "]")
        return lambda: a.matsolve(b), lambda x: ck_list([back(x[i, 0]) for i in range(n)])
    if name == "inverse A_n":
        a = g("[" + ";".join(",".join(map(str, r)) for r in a_n(n)) + "]")
        return lambda: a**-1, lambda x: ck_list([back(x[i, j]) for i in range(n + 1) for j in range(n + 1)])


def sympy(name, sizes):
    import sympy as sp
    from sympy.polys.matrices import DomainMatrix

    n = sizes[0]
    if name in ("gcd", "exact division"):
        ring = sp.ring(["x", "y", "z", "w"][:n], sp.ZZ)[0]
        a, b, c = in_gcd(*sizes)
        x, y, f = (ring.from_dict(p) for p in (times(a, c), times(b, c), c))
        if name == "gcd":
            return lambda: x.gcd(y), lambda g: ck_terms((e, Fraction(c)) for e, c in primitive(g.terms()))
        return lambda: x.exquo(f), lambda g: ck_terms((e, Fraction(int(c))) for e, c in g.terms())
    if name == "identities":
        texts = identities(n, "**")
        return lambda: sum(sp.expand(sp.sympify(l) - sp.sympify(r)) == 0 for l, r in texts), int
    back = lambda x: Fraction(int(x.numerator), int(x.denominator))
    if name in ("solve", "determinant") and n <= 50:
        a, b = system(n)
        a = DomainMatrix(a, (n, n), sp.ZZ).convert_to(sp.QQ)
        if name == "determinant":
            return lambda: a.det(), lambda d: modp(back(d))
        b = DomainMatrix([[x] for x in b], (n, 1), sp.ZZ).convert_to(sp.QQ)
        return lambda: a.lu_solve(b), lambda x: ck_list([back(v) for r in x.to_list() for v in r])


def symbolica(name, sizes):
    import symbolica as sy

    n = sizes[0]
    E = lambda x: sy.E(str(x))
    plain = lambda e: e.format_plain().replace(" ", "")
    number = lambda c: Fraction(plain(c))
    variables = [sy.S(v) for v in "xyzw"]
    t = sy.S("t")

    def formula(p):
        return E("+".join("(%d)*" % c + "*".join("%s^%d" % (v, e) for v, e in zip("xyzw", es)) for es, c in p.items()))

    def terms(p):
        # A polynomial knows the variables that it has.
        places = ["xyzw".index(plain(v).split("::")[-1]) for v in p.get_variables()]
        for exponents, c in p.coefficient_list():
            full = [0, 0, 0, 0]
            for place, e in zip(places, exponents):
                full[place] = e
            yield tuple(full), number(c)

    poly = lambda c: E("+".join("(%s)*t^%d" % (x, k) for k, x in enumerate(c))).to_polynomial(vars=[t])

    def coefficients(f):
        out = {}
        for exponents, c in f.coefficient_list():
            out[exponents[0] if exponents else 0] = number(c)
        return [out.get(k, Fraction(0)) for k in range(max(out, default=-1) + 1)]

    if name in ("gcd", "exact division"):
        a, b, c = in_gcd(*sizes)
        x, y, f = (formula(p).to_polynomial(vars=variables[:n]) for p in (times(a, c), times(b, c), c))
        if name == "gcd":

            def value(h):
                h = list(terms(h))
                scale = lcm(*(c.denominator for _, c in h))
                return ck_terms((e, Fraction(c)) for e, c in primitive((e, scale * c) for e, c in h))

            return lambda: x.gcd(y), value
        return lambda: x.quot_rem(f)[0], lambda g: ck_terms(terms(g))
    if name == "sparse product":
        x, y = (formula(p).to_polynomial(vars=variables) for p in in_gcd(4, n, 100)[:2])
        return lambda: x * y, lambda g: ck_terms(terms(g))
    if name == "product":
        lcg = Lcg(400 + n)
        f, h = (poly([lcg.bigrat(64, 16) for _ in range(n + 1)]) for _ in range(2))
        return lambda: f * h, lambda r: ck_poly(coefficients(r))
    if name == "division":
        f, h = (poly(p) for p in polynomials(4000, sizes))
        return lambda: f.quot_rem(h), lambda r: residues(ck_poly(coefficients(x)) for x in r)
    if name == "gcd in t":
        a, b, c = (poly(p) for p in polynomials(5000, 3 * [n]))
        x, y = a * c, b * c
        return lambda: x.gcd(y), lambda h: ck_poly([c / coefficients(h)[-1] for c in coefficients(h)])
    if name == "interpolation":
        nodes, values = interpolation(n)
        values = [E(v).to_polynomial() for v in values]
        return lambda: sy.Polynomial.interpolate(t, nodes, values), lambda r: ck_list((coefficients(r) + n * [Fraction(0)])[:n])
    if name == "polar value":
        f, u = polar(n)
        factors = [poly([x.denominator, x.numerator]) for x in u]
        weights = [E(c / comb(n, k)) for k, c in enumerate(f)]
        common = tree([x.denominator for x in u])

        def value():
            total = E(0)
            for exponents, c in tree(factors).coefficient_list():
                total = total + c.to_expression() * weights[exponents[0]]
            return total / E(common)

        return value, lambda v: modp(number(v))
    if name == "spline basis":
        moments = knots()
        linear = lambda a, b: poly([a, b])
        return lambda: basis(n, moments, linear), lambda r: residues(ck_poly(coefficients(f)) for f in r)
    if name in ("solve", "determinant"):
        a, b = system(n)
        a = sy.Matrix.from_nested([[E(x) for x in r] for r in a])
        scalar = lambda x: number(x.to_expression() if hasattr(x, "to_expression") else x)
        if name == "determinant":
            return lambda: a.det(), lambda d: modp(scalar(d))
        b = sy.Matrix.from_nested([[E(x)] for x in b])
        return lambda: a.solve(b), lambda x: ck_list([scalar(x[i, 0]) for i in range(n)])
    if name == "inverse A_n":
        a = sy.Matrix.from_nested([[E(x) for x in r] for r in a_n(n)])
        scalar = lambda x: number(x.to_expression() if hasattr(x, "to_expression") else x)
        return lambda: a.inv(), lambda m: ck_list([scalar(m[i, j]) for i in range(n + 1) for j in range(n + 1)])
    if name == "identities":
        texts, zero = identities(n), E(0)
        return lambda: sum((sy.E(l) - sy.E(r)).expand() == zero for l, r in texts), int


PEERS = {"FLINT": flint, "PARI": pari, "SymPy": sympy, "Symbolica": symbolica}


def run_peer(peer, case):
    name, sizes = case.split("/")
    made = PEERS[peer](name, [int(s) for s in sizes.split(",")])
    if made is None:
        return
    run, checksum = made
    result, best, spent, runs = run(), float("inf"), 0.0, 0
    while runs < 3 or (spent < 1 and runs < 50):
        begin = time.process_time()
        result = run()
        took = time.process_time() - begin
        best, spent, runs = min(best, took), spent + took, runs + 1
    print(f"{best:e} {checksum(result)}")


def ask(command):
    # The checksum of a large result takes some of them minutes.
    limit = 8 * LIMIT if command[-1].startswith("sparse") else LIMIT
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return None
    words = done.stdout.splitlines()[-1].split() if done.stdout else []
    if done.returncode or len(words) != 2:
        if done.stderr and "No module named" not in done.stderr:
            print(done.stderr.splitlines()[-1][:200], file=sys.stderr)
        return None
    return float(words[0]), int(words[1])


def shown(seconds):
    return "–" if seconds is None else f"{seconds * 1e6:.3g} us" if seconds < 1e-3 else f"{seconds * 1e3:.3g} ms"


def main():
    if len(sys.argv) == 3:
        return run_peer(*sys.argv[1:])
    if len(sys.argv) == 2:
        ours = sys.argv[1]  # a built program
    else:
        built = subprocess.run(
            ["cargo", "bench", "--bench", "peers", "--no-run", "--message-format=json"], capture_output=True, text=True, check=True
        )
        artifacts = [json.loads(line) for line in built.stdout.splitlines() if line.startswith("{")]
        ours = next(a["executable"] for a in artifacts if a.get("target", {}).get("name") == "peers" and a.get("executable"))
    cases = subprocess.run([ours, "--list"], capture_output=True, text=True, check=True).stdout.splitlines()
    print("| operation | polarform | " + " | ".join(PEERS) + " | ours / best |")
    print("| --- |" + " ---: |" * (len(PEERS) + 2))
    for case in cases:
        best, checksums = {}, set()
        for _ in range(ROUNDS):
            for side in ["ours", *PEERS]:
                command = [ours, case] if side == "ours" else [sys.executable, __file__, side, case]
                answer = ask(command)
                if answer:
                    seconds, checksum = answer
                    best[side] = min(best.get(side, seconds), seconds)
                    checksums.add(min(checksum, P - checksum) if case.startswith("gcd/") else checksum)
        others = [best[p] for p in PEERS if p in best]
        ratio = f"{best['ours'] / min(others):.2f}" if others and "ours" in best else "–"
        agreed = "" if len(checksums) == 1 else " CHECKSUMS DIFFER"
        cells = [shown(best.get(side)) for side in ["ours", *PEERS]]
        print(f"| {case}{agreed} | " + " | ".join(cells) + f" | {ratio} |", flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""What SymPy's LaTeX printer writes, read by polarform: no formula may become another one in silence.

    python3 -m venv venv && venv/bin/pip install sympy
    cargo build && venv/bin/python tests/sympy_latex.py [--count 8000] [--seed 1] [--program PATH]

Random polynomials, fractions, powers, sums, products, binomials, factorials, derivatives, integrals,
matrices, relations and lists, in Latin, Greek and indexed symbols, each printed with one of the 15 settings
below. The answers are taken as SymPy syntax and compared at random rational points: exactly. A relation must not be
proved if it is false, nor refuted if it is true. What differs and comes with a note is counted apart ("warned"). It
ends with status 1 if anything differs in silence.
"""
import argparse
import os
import random
import re
import subprocess
import sys
from collections import Counter

import sympy as sp

SETTINGS = [
    {},
    {"fold_frac_powers": True},
    {"fold_short_frac": True},
    {"long_frac_ratio": 2},
    {"long_frac_ratio": 1, "order": "rev-lex"},
    {"mul_symbol": "dot"},
    {"mul_symbol": "times"},
    {"mul_symbol": "ldot"},
    {"mat_str": "bmatrix", "mat_delim": ""},
    {"mat_str": "array", "mat_delim": "("},
    {"order": "lex", "mode": "equation"},
    {"order": "old", "mode": "inline"},
    {"mode": "equation*", "itex": True, "ln_notation": True},
    {"fold_short_frac": True, "mode": "inline", "inv_trig_style": "power", "imaginary_unit": "j"},
    {"decimal_separator": "comma", "parenthesize_super": False, "root_notation": False},
]
NAMES = "x y z t u a b c k n alpha beta gamma lambda mu tau omega x_1 x_2 t_0 t_12 b_0 b_i c_ij alpha_1 beta_i".split()
MARK = 987654321123456789  # printed after each answer, to find it again


class Draw:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.symbols = sp.symbols(NAMES)

    def choice(self, items):
        return self.random.choice(items)

    def number(self):
        small = self.random.randint(-9, 12)
        return self.choice([sp.Integer(small), sp.Rational(small, self.random.randint(1, 12)), sp.Integer(small * 137)])

    def scalar(self, depth):
        """A formula with a rational value at rational points."""
        if depth == 0 or self.random.random() < 0.15:
            return self.choice(self.symbols) if self.random.random() < 0.7 else self.number()
        kinds = [self.sum, self.sum, self.product, self.product, self.quotient, self.power, self.leaf]
        return self.choice(kinds)(depth - 1)

    def sum(self, depth):
        return sp.Add(*[self.scalar(depth) for _ in range(self.random.randint(2, 4))])

    def product(self, depth):
        return sp.Mul(*[self.scalar(depth) for _ in range(self.random.randint(2, 3))])

    def quotient(self, depth):
        below = self.scalar(depth)
        return self.scalar(depth) / below if sp.expand(sp.together(below.doit())) != 0 else self.scalar(depth)

    def power(self, depth):
        base, exponent = self.scalar(depth), self.random.randint(-2, 4)
        if exponent < 0 and sp.expand(sp.together(base.doit())) == 0:
            exponent = 2
        return sp.Pow(base, exponent)

    def leaf(self, depth):
        i, x = sp.Symbol("m"), self.choice(self.symbols)
        n, k = self.random.randint(0, 7), self.random.randint(0, 5)
        polynomial = sp.Add(*[self.random.randint(-5, 5) * x**self.random.randint(0, 4) for _ in range(3)])
        return self.choice([
            lambda: sp.Sum(self.scalar(1).subs(x, i) * i, (i, self.random.randint(0, 2), self.random.randint(2, 4))),
            lambda: sp.Product(x + i, (i, 1, self.random.randint(1, 4))),
            lambda: sp.binomial(n, k, evaluate=False),
            lambda: sp.factorial(sp.Integer(n), evaluate=False),
            lambda: sp.Derivative(polynomial * self.choice(self.symbols), x),
            lambda: sp.Derivative(polynomial, (x, 2)),
            lambda: sp.Integral(polynomial, (x, self.random.randint(-2, 2), self.random.randint(-2, 2))),
            lambda: sp.Abs(sp.Rational(self.random.randint(-9, 9), 7), evaluate=False),
            lambda: sp.floor(sp.Rational(self.random.randint(-9, 9), 4), evaluate=False),
            lambda: sp.Float(self.random.randint(-400, 400)) / 16,
            lambda: sp.Max(n, sp.Rational(k, 3), evaluate=False),
            lambda: sp.gcd(n + 1, k + 1) * x,
        ])()

    def relation(self):
        left = self.scalar(2)
        right = self.choice([sp.expand(left), sp.factor(left), left + 1, self.scalar(1)])
        return self.choice([sp.Eq, sp.Eq, sp.Eq, sp.Ne, sp.Lt, sp.Le, sp.Gt, sp.Ge])(left, right, evaluate=False)

    def matrix(self):
        rows, columns = self.random.randint(1, 3), self.random.randint(1, 3)
        return sp.Matrix(rows, columns, [self.scalar(1) for _ in range(rows * columns)])

    def formula(self):
        kind = self.random.random()
        if kind < 0.75:
            return self.scalar(self.random.randint(1, 3))
        if kind < 0.83:
            return self.relation()
        if kind < 0.9:
            return self.matrix()
        if kind < 0.94:
            left = self.matrix()
            return sp.MatMul(self.choice(self.symbols[:8]), left, left.T, evaluate=False)
        items = [self.scalar(1) for _ in range(self.random.randint(2, 4))]
        return self.choice([list, tuple])(items)


def answers(program, formulas):
    """What the program answers to each formula, and what it says to it on standard error."""
    lines = [":sympy"]
    for formula in formulas:
        lines += [formula, str(MARK), ":reset"]
    environment = {**os.environ, "NO_COLOR": "1"}
    ran = subprocess.run([program], input="\n".join(lines), capture_output=True, text=True, env=environment)
    return ran.stdout.split(f"{MARK}\n")[:-1]


def warned(program, formula):
    """Whether the program says that something may be meant otherwise."""
    ran = subprocess.run([program, "eval", "--", formula], capture_output=True, text=True)
    return any(word in ran.stderr for word in ("note[", "warning["))


def canonical(name):
    """`x_{1}`, `x1` and `x_1` are one name; `lambda_` is `lambda`."""
    return re.sub(r"[\\{}_ \[\],]", "", name)


def value(text):
    """An answer in SymPy syntax; indexed names become symbols."""
    text = re.sub(r"([A-Za-z_]\w*)\[([\w, ]+)\]", lambda m: m[1] + re.sub(r"\W", "", m[2]), text)
    words = set(re.findall(r"[A-Za-z_]\w*", text)) - {"Matrix", "Rational", "True", "False"}
    return sp.sympify(text, locals={word: sp.Symbol(canonical(word)) for word in words})


def exact(expr):
    """The decimals of an expression as fractions."""
    return expr.xreplace({atom: sp.nsimplify(atom, rational=True) for atom in expr.atoms(sp.Float)})


def at_point(expr, seed):
    """An expression at a point that depends on the names only."""
    def place(symbol):
        draw = random.Random(f"{seed} {canonical(symbol.name)}")
        return sp.Rational(draw.randint(2, 99), draw.choice([7, 11, 13, 17]))

    expr = exact(expr).doit()
    return expr.xreplace({symbol: place(symbol) for symbol in expr.free_symbols})


def differs(expected, found):
    """Whether two formulas differ at one of some points; poles are passed over."""
    for seed in range(3):
        one, other = at_point(expected, seed), at_point(found, seed)
        if sp.zoo in (one, other) or sp.nan in (one, other):
            continue
        if sp.simplify(one - other) != 0:
            return True
    return False


def truth(relation):
    """True or false where that is certain for all values, else None."""
    difference = sp.simplify((relation.lhs - relation.rhs).doit())
    if not difference.is_number:
        return {"==": False, "!=": None}.get(relation.rel_op) if relation.rel_op in ("==",) else None
    return bool(relation.func(sp.nsimplify(difference, rational=True), 0))


def judge(expected, answer):
    """"right", "different" or "open"; an answer that is empty was refused."""
    answer = answer.strip()
    if not answer:
        return "refused"
    if isinstance(expected, sp.core.relational.Relational):
        wanted = truth(expected)
        found = {"True": True, "False": False, "None": None}.get(answer, answer)
        if isinstance(found, str):  # a definition: the right side is its value
            is_name = isinstance(expected, sp.Eq) and expected.lhs.is_Symbol
            return "right" if is_name and not differs(expected.rhs, value(found)) else "different"
        if found is None:
            return "open"
        if wanted is None:  # for some values only: neither proved nor, but for an equation, refuted
            difference = expected.lhs - expected.rhs
            holds = all(expected.func(at_point(difference, seed), 0) == True for seed in range(20))  # noqa: E712
            return "different" if found and not holds else "right"
        return "right" if found == wanted else "different"
    found = value(answer)
    if isinstance(expected, (list, tuple)):
        alike = isinstance(found, (list, tuple, sp.Tuple)) and len(found) == len(expected)
        return "right" if alike and not any(map(differs, expected, found)) else "different"
    if isinstance(expected, (sp.MatrixBase, sp.MatMul)):
        expected = sp.Matrix(exact(expected).doit())
        if not isinstance(found, sp.MatrixBase):
            return "different"
        alike = found.shape == expected.shape
        return "right" if alike and not any(map(differs, expected, found)) else "different"
    return "different" if isinstance(found, (list, sp.MatrixBase)) or differs(expected, found) else "right"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--count", type=int, default=8000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--program", default="target/debug/polarform")
    parser.add_argument("--refused", action="store_true", help="show what was refused, too")
    options = parser.parse_args()
    draw, verdicts = Draw(options.seed), Counter()
    cases = []
    while len(cases) < options.count:
        setting = SETTINGS[len(cases) % len(SETTINGS)]
        formula = draw.formula()
        # SymPy prints 15 digits of a float: only those that it prints exactly.
        atoms = formula.atoms(sp.Float) if isinstance(formula, sp.Basic) else set()
        if any(len(str(atom).rstrip("0")) > 12 for atom in atoms):
            continue
        text = sp.latex(formula, **setting)
        text = text if text.startswith(("$", "\\begin{equation")) else f"${text}$"
        cases.append((formula, setting, text.replace("\n", " ")))
    for start in range(0, len(cases), 500):
        part = cases[start : start + 500]
        found = answers(options.program, [text for _, _, text in part])
        if len(found) != len(part):
            sys.exit(f"{len(part)} formulas, {len(found)} answers, from case {start}")
        for (formula, setting, text), answer in zip(part, found):
            try:
                verdict = judge(formula, answer)
            except Exception as trouble:  # an answer that is no SymPy syntax is as bad as a wrong one
                verdict, answer = "different", f"{answer.strip()} ({trouble!r:.90})"
            if verdict == "different" and warned(options.program, text):
                verdict = "warned"
            verdicts[verdict] += 1
            if verdict == "different" or options.refused and verdict == "refused":
                print(f"{verdict}: {text}\n  {setting}\n  {sp.srepr(formula) if len(text) < 60 else formula}\n  {answer.strip()}")
    print(f"{len(cases)} formulas, {len(SETTINGS)} settings: {dict(verdicts)}")
    sys.exit(1 if verdicts["different"] else 0)


if __name__ == "__main__":
    main()

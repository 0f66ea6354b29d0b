//! Trees and error messages of the plain notation.

mod robust;

use std::fmt::Write as _;

use super::*;
use crate::formula::source::SourceFile;
use crate::formula::{Kind, Rel, Sign};
use crate::language::diagnostic::render;

/// A tree in one line: `(* a (^ b 2))`.
fn show(expr: &Expr) -> String {
    let list = |head: &str, items: &[Expr]| {
        items.iter().fold(format!("({head}"), |text, item| text + " " + &show(item)) + ")"
    };
    let optional = |item: &Option<Box<Expr>>| item.as_ref().map_or("-".to_owned(), |item| show(item));
    match &expr.kind {
        Kind::Number(value) => value.to_string(),
        Kind::Name(name) => name.clone(),
        Kind::Subscript(base, indices) => format!("{}[{}]", show(base), joined(indices)),
        Kind::Upper(base, indices) => format!("{}^[{}]", show(base), joined(indices)),
        Kind::Accent(accent, body) => format!("({accent:?} {})", show(body)),
        Kind::Prime(body, count) => format!("(prime{count} {})", show(body)),
        Kind::Add(terms) => {
            let mut text = "(+".to_owned();
            for term in terms {
                let sign = if term.sign == Sign::Minus { "-" } else { "" };
                write!(text, " {sign}{}", show(&term.expr)).expect("strings take any text");
            }
            text + ")"
        }
        Kind::Mul(factors) => list("*", factors),
        Kind::Div(a, b, _) => format!("(/ {} {})", show(a), show(b)),
        Kind::Pow(a, b) => format!("(^ {} {})", show(a), show(b)),
        Kind::Apply(callee, groups) => {
            let groups: Vec<String> = groups.iter().map(|group| joined(group)).collect();
            format!("(call {} {})", show(callee), groups.join("; "))
        }
        Kind::Group(body) => format!("<{}>", show(body)),
        Kind::Tuple(items) => list("tuple", items),
        Kind::List(items) => list("list", items),
        Kind::Set(items, None) => list("set", items),
        Kind::Set(items, Some(condition)) => format!("{} | {}", list("set", items), show(condition)),
        Kind::Matrix(rows, _) => {
            let row = |row: &Vec<Option<Expr>>| {
                row.iter().map(|c| c.as_ref().map_or("_".into(), show)).collect::<Vec<_>>().join(" ")
            };
            format!("(matrix {})", rows.iter().map(row).collect::<Vec<_>>().join("; "))
        }
        Kind::Binomial(n, k, _) => format!("(binomial {} {})", show(n), show(k)),
        Kind::Factorial(body) => format!("(! {})", show(body)),
        Kind::Enclosed(enclosure, body) => format!("({enclosure:?} {})", show(body)),
        Kind::Big { op, lower, upper, body } => {
            format!("({op:?} {} .. {} : {})", joined(lower), optional(upper), show(body))
        }
        Kind::Integral { lower, upper, body, variable } => {
            format!("(integral {} {} {} : {})", show(variable), optional(lower), optional(upper), show(body))
        }
        Kind::Cases(cases) => {
            let mut text = "(cases".to_owned();
            for (value, condition) in cases {
                let condition = condition.as_ref().map_or("else".to_owned(), show);
                write!(text, " {} if {condition};", show(value)).expect("strings take any text");
            }
            text + ")"
        }
        Kind::Ellipsis => "...".to_owned(),
        Kind::Compose(items) => list("o", items),
        Kind::Transpose(body) => format!("(transpose {})", show(body)),
        Kind::Range(a, b) => format!("(.. {} {})", show(a), show(b)),
        Kind::Lambda(parameters, body) => format!("(fn {} -> {})", joined(parameters), show(body)),
        Kind::Chain(first, links) => {
            let mut text = format!("{{{}", show(first));
            for link in links {
                write!(text, " {:?} {}", link.rel, show(&link.expr)).expect("strings take any text");
            }
            text + "}"
        }
        Kind::Sequence(items) => list("seq", items),
        Kind::Text(words) => format!("{words:?}"),
        other => panic!("the plain notation has no {other:?}"),
    }
}

fn joined(items: &[Expr]) -> String {
    items.iter().map(show).collect::<Vec<_>>().join(",")
}

#[track_caller]
fn reads(text: &str, tree: &str) {
    match parse(text) {
        Ok(expr) => {
            assert_eq!(show(&expr), tree, "{text}");
            assert_spans(&expr, text);
        }
        Err(problem) => panic!("{}", render(&problem, &SourceFile::new("<test>", text), false)),
    }
}

#[track_caller]
fn same(a: &str, b: &str) {
    let (left, right) = (parse(a).expect(a), parse(b).expect(b));
    assert!(left.same_as(&right), "{a} reads {}, {b} reads {}", show(&left), show(&right));
}

/// Spans lie in the text, on character boundaries, children within their parents.
#[track_caller]
fn assert_spans(expr: &Expr, text: &str) {
    let span = expr.span;
    assert!(text.get(span.range()).is_some(), "{span:?} in {text:?}");
    assert!(!span.is_empty(), "{span:?} in {text:?}");
    if let Kind::Chain(_, links) = &expr.kind {
        assert!(links.iter().all(|link| link.span.start >= span.start && link.span.end <= span.end));
    }
    expr.for_each_child(&mut |child| {
        assert!(child.span.start >= span.start && child.span.end <= span.end, "{child:?} in {text:?}");
        assert_spans(child, text);
    });
}

#[test]
fn numbers_and_names() {
    reads("3", "3");
    reads("0.25", "1/4");
    reads(".5", "1/2");
    reads("t", "t");
    reads("alpha", "alpha");
    for index in ["t12", "t_12", "t_{12}", "t_(12)", "t₁₂", "ｔ１２"] {
        reads(index, "t[12]");
    }
    for greek in ["sigma", "σ", r"\sigma"] {
        reads(greek, "sigma");
        reads(&format!("{greek}_{{i,n}}"), "sigma[i,n]");
    }
    reads("pts2", "pts[2]");
    reads("c_0", "c[0]");
    reads("c_i", "c[i]");
    reads("p_{i,j}", "p[i,j]");
    reads("p_{i+1,j-1}", "p[(+ i 1),(+ j -1)]");
    reads("a_xy", "a[xy]");
    reads("max_terms", "max_terms");
    reads("sigma_xy", "sigma[xy]");
    reads("a_t1", "a[t[1]]");
    reads("b_{01}", "b[01]");
    reads("b01", "b[01]");
    assert!(
        matches!(parse("b_01").unwrap().kind, Kind::Subscript(_, ref i) if i[0].same_as(&Expr::name("01")))
    );
    reads("b_{0}", "b[0]");
    reads("tₙ₋₁", "t[(+ n -1)]");
    reads("ℝ", "(Blackboard R)");
    reads("∞", "infty");
    reads("1̂", "(Hat 1)");
    reads("v̂1", "(Hat v)[1]");
    reads("Bézier", "Bézier");
    reads("\"two words\"", "\"two words\"");
}

#[test]
fn products() {
    for product in ["c t", "c*t", "c·t", "c × t", r"c \cdot t", "c⋅t"] {
        reads(product, "(* c t)");
    }
    reads("2t", "(* 2 t)");
    reads("3t1t2", "(* 3 t[1] t[2])");
    reads("t_1t_2", "(* t[1] t[2])");
    reads("t₁t₂", "(* t[1] t[2])");
    reads("αβ", "(* alpha beta)");
    reads("(t+1)(t-1)", "(* <(+ t 1)> <(+ t -1)>)");
    reads("2(t+1)", "(* 2 <(+ t 1)>)");
    reads("t_1 2", "(* t[1] 2)");
    reads("5/3 (t1+t2)", "(* (/ 5 3) <(+ t[1] t[2])>)");
    reads("5/3(t1+t2)", "(* (/ 5 3) <(+ t[1] t[2])>)");
    reads("a b c", "(* a b c)");
    reads("a b / c d", "(* (/ (* a b) c) d)");
    reads("a/b/c", "(/ (/ a b) c)");
    reads("1/2t^2", "(* (/ 1 2) (^ t 2))");
    reads("a*-b", "(* a (+ -b))");
    reads("a * -b c", "(* a (+ -b) c)");
    reads("a / -b^2", "(/ a (+ -(^ b 2)))");
    reads("t_1 ... t_n", "(* t[1] ... t[n])");
    reads("t_1…t_n", "(* t[1] ... t[n])");
}

#[test]
fn sums_and_signs() {
    reads("a - b + c", "(+ a -b c)");
    reads("-t^2", "(+ -(^ t 2))");
    reads("−t²", "(+ -(^ t 2))");
    reads("-a b + c", "(+ -(* a b) c)");
    reads("a - -b c", "(+ a -(+ -(* b c)))");
    reads("--a", "(+ -(+ -a))");
    reads("+1", "(+ 1)");
    reads("+a - b", "(+ a -b)");
    reads("1 + ... + n", "(+ 1 ... n)");
    reads("a - (b - c)", "(+ a -<(+ b -c)>)");
}

#[test]
fn powers() {
    reads("t^2", "(^ t 2)");
    reads("t**2", "(^ t 2)");
    reads("t²", "(^ t 2)");
    reads("t⁻¹", "(^ t (+ -1))");
    reads("2^-1", "(^ 2 (+ -1))");
    reads("2^-n^2", "(^ 2 (+ -(^ n 2)))");
    reads("2^3^2", "(^ 2 (^ 3 2))");
    reads("2^-1 b", "(* (^ 2 (+ -1)) b)");
    reads("t^{12}", "(^ t 12)");
    reads("t^{n-1} s", "(* (^ t (+ n -1)) s)");
    reads("t_1^2", "(^ t[1] 2)");
    reads("t₁²", "(^ t[1] 2)");
    reads("M^T", "(^ M T)");
    reads("Mᵀ", "(^ M T)");
    reads("2^{(3)}", "(^ 2 <3>)");
    reads("2^n!", "(^ 2 (! n))");
    reads("(1-t)^(n-i)", "(^ <(+ 1 -t)> <(+ n -i)>)");
    reads("t^binomial(n,2)", "(^ t (binomial n 2))");
    assert_eq!(parse("t^{12}").unwrap().span, Span::new(0, 6));
}

#[test]
fn upper_indices_and_primes() {
    reads("f^{(2)}(t)", "(call f^[2] t)");
    reads("f^{(+1)}", "f^[(+ 1)]");
    reads("p_i^{(k)}", "p[i]^[k]");
    reads("f⁽²⁾(t)", "(call f^[2] t)");
    reads("f^{(1,2)}", "f^[1,2]");
    reads("f^{(2)+1}", "(^ f (+ <2> 1))");
    reads("F'(t)", "(call (prime1 F) t)");
    for prime in ["F''", "F’’", "F″", "F′′"] {
        reads(prime, "(prime2 F)");
    }
    reads("(F G)'(t)", "(call (prime1 <(* F G)>) t)");
    reads("n!", "(! n)");
    reads("n! != 3", "{(! n) Ne 3}");
    reads("(n-k)! k!", "(* (! <(+ n -k)>) (! k))");
}

#[test]
fn calls() {
    reads("f(t)", "(call f t)");
    reads("f (t)", "(* f <t>)");
    reads("c_2 (t1+t2)", "(* c[2] <(+ t[1] t[2])>)");
    reads("f_1(t)", "(call f[1] t)");
    reads("f(a)(b)", "(call (call f a) b)");
    reads("f(u1,u2; v1)", "(call f u[1],u[2]; v[1])");
    reads("f(; v)", "(call f ; v)");
    reads("f()", "(call f )");
    reads("B_i^n(t)", "(call (^ B[i] n) t)");
    reads("Bᵢⁿ(t)", "(call (^ B[i] n) t)");
    reads("B_1^2(t)", "(call (^ B[1] 2) t)");
    reads("B_i^{n-1}(t)", "(call (^ B[i] (+ n -1)) t)");
    reads("t^n(t)", "(call (^ t n) t)");
    reads("t^2(t+1)", "(* (^ t 2) <(+ t 1)>)");
    reads("t²(t+1)", "(* (^ t 2) <(+ t 1)>)");
    reads("2^n(t)", "(* (^ 2 n) <t>)");
    reads("(1-t)^2(t)", "(* (^ <(+ 1 -t)> 2) <t>)");
    reads("f(t)^2(t)", "(* (^ (call f t) 2) <t>)");
    reads("polar(t^3, degree=4)", "(call polar (^ t 3),{degree Eq 4})");
    reads("polar(F)(0, 1/2)", "(call (call polar F) 0,(/ 1 2))");
    reads("(f+g)(0,1)", "(call <(+ f g)> 0,1)");
    reads("(F∘G)(t)", "(call <(o F G)> t)");
    reads("(t -> t^2)(3)", "(call <(fn t -> (^ t 2))> 3)");
    reads("F(t)^2", "(^ (call F t) 2)");
    reads("diff(F, t, 2)", "(call diff F,t,2)");
}

#[test]
fn brackets() {
    reads("(t)", "<t>");
    reads("(a, b)", "(tuple a b)");
    reads("[a, b]", "(list a b)");
    reads("[]", "(list)");
    reads("[1, 2; 3, 4]", "(matrix 1 2; 3 4)");
    reads("[1, 2;]", "(matrix 1 2)");
    reads("[1; 2]", "(matrix 1; 2)");
    reads("[1, ; 2, 3]", "(matrix 1 _; 2 3)");
    reads("{a, b}", "(set a b)");
    reads("{}", "(set)");
    reads("{x | x > 0}", "(set x) | {x Gt 0}");
    reads("（a，b）", "(tuple a b)");
    reads("⌊n/2⌋", "(Floor (/ n 2))");
    reads("((t))", "<<t>>");
}

#[test]
fn special_calls() {
    reads("f(t, t, hat(1))", "(call f t,t,(Hat 1))");
    reads("hat(v)", "(Hat v)");
    reads("bar(x) + vec(v)", "(+ (Bar x) (Vec v))");
    reads("dot(a, b)", "(call dot a,b)");
    reads("abs(x) norm(x) floor(x) ceil(x)", "(* (Abs x) (Norm x) (Floor x) (Ceil x))");
    reads("binomial(n,k)", "(binomial n k)");
    reads("binom(n, k) t^k", "(* (binomial n k) (^ t k))");
    reads("transpose(M)", "(transpose M)");
    reads("compose(F, G, H)", "(o F G H)");
    reads(r"F \circ G", "(o F G)");
    reads("a F∘G", "(* a (o F G))");
    reads("sum(i=0..n, c_i t^i)", "(Sum {i Eq 0} .. n : (* c[i] (^ t i)))");
    reads("sum(i=0..n, j=0..i, i j)", "(Sum {i Eq 0} .. n : (Sum {j Eq 0} .. i : (* i j)))");
    reads("prod(j=0..n, j != i, t - t_j)", "(Product {j Eq 0},{j Ne i} .. n : (+ t -t[j]))");
    reads("sum(x in S, x)", "(Sum {x In S} .. - : x)");
    reads("max(a, b)", "(call max a,b)");
    reads("max(i=0..2, a_i)", "(Max {i Eq 0} .. 2 : a[i])");
    reads("sum(F, G)", "(call sum F,G)");
    reads("integral(t^2, t=a..b)", "(integral t a b : (^ t 2))");
    reads("integral(t^2, t)", "(integral t - - : (^ t 2))");
    reads("cases(1 if i = 0, t if i > 0, 0 otherwise)", "(cases 1 if {i Eq 0}; t if {i Gt 0}; 0 if else;)");
    reads("sum sum1", "(* sum sum[1])");
}

#[test]
fn relations_and_functions() {
    reads("F(t) := t^2 + 2t", "{(call F t) Define (+ (^ t 2) (* 2 t))}");
    reads("x := a = b", "{x Define {a Eq b}}");
    reads("a = b <= c", "{a Eq b Le c}");
    reads("a == b != c", "{a Eq b Ne c}");
    reads("a ≠ b ≤ c ≥ d ≈ e", "{a Ne b Le c Ge d Approx e}");
    reads("x in S", "{x In S}");
    reads("x ∈ [0,1]", "{x In (list 0 1)}");
    reads("A ⊆ B => C <=> D", "{A Subset B Implies C Iff D}");
    reads("0..n", "(.. 0 n)");
    reads("0..n-1", "(.. 0 (+ n -1))");
    reads("1...5", "(* 1 ... 5)");
    reads("t -> t^2", "(fn t -> (^ t 2))");
    reads("t ↦ t²", "(fn t -> (^ t 2))");
    reads("G := (i, n) -> i/n", "{G Define (fn i,n -> (/ i n))}");
    reads("t -> u -> t u", "(fn t -> (fn u -> (* t u)))");
    reads("a = b, c = d", "(seq {a Eq b} {c Eq d})");
    reads("i = 1, ..., n", "(seq {i Eq 1} ... n)");
    assert!(matches!(&parse("a = b").unwrap().kind,
        Kind::Chain(_, links) if links[0].rel == Rel::Eq && links[0].span == Span::new(2, 3)));
}

#[test]
fn names_for_the_same_formula() {
    same("F(t)=t^2", "F(t) == t²");
    same("F∘G", "compose(F, G)");
    same("c_0+c_1 t", "c0 + c1*t # linear");
    same("(t\n + 1)", "(t+1)");
    same("t1 +\n t2", "t1+t2");
    same("F(t)\n = t^2", "F(t) = t^2");
    same("t^{ n }", "t^n");
    same("t,t", "t ,t");
}

#[test]
fn programs() {
    let text = "# heading\nF := t^2;G := t # two\n\n(F,\n G)\n h := [1; 2]; \n";
    let results = parse_program(text);
    let shown: Vec<String> = results.iter().map(|r| show(r.as_ref().expect("all are formulas"))).collect();
    assert_eq!(shown, ["{F Define (^ t 2)}", "{G Define t}", "(tuple F G)", "{h Define (matrix 1; 2)}"]);
    for result in results {
        assert_spans(&result.expect("a formula"), text);
    }
    assert!(parse_program(" # nothing\n ; ; \n").is_empty());
    // An open bracket does not swallow the lines after it.
    let results = parse_program("a := (1\nb := 2\nc := (3\n)");
    assert_eq!(results.iter().map(Result::is_ok).collect::<Vec<_>>(), [false, true, true]);
}

#[test]
fn sentences_are_statements() {
    let pieces = |text: &'static str| -> Vec<&str> {
        super::statements(text).unwrap().into_iter().map(|span| &text[span.range()]).collect()
    };
    assert_eq!(pieces("Let F(t) = t^2. Let G(t) = t."), ["Let F(t) = t^2.", "Let G(t) = t"]);
    assert_eq!(pieces("F(1)。 G(2)"), ["F(1)", "G(2)"]);
    // What is asked of a definition belongs to it, and these points end no sentence.
    for text in ["F(t) = t^2. Find F(2)", "t^2 w.r.t. t", "[1. 2]", "t^2 .. 3", "1.5", "a.b"] {
        assert_eq!(pieces(text).len(), 1, "{text}");
    }
}

#[test]
fn statements_of_mixed_notation() {
    let cut = |text| -> Vec<String> {
        statements(text).unwrap().into_iter().map(|span| text[span.range()].to_owned()).collect()
    };
    assert_eq!(cut("$a;\n b$; c"), ["$a;\n b$", "c"]);
    assert_eq!(cut("\\begin{matrix} 1;2\n\\end{matrix}\nx"), ["\\begin{matrix} 1;2\n\\end{matrix}", "x"]);
    assert_eq!(cut(r"a \; b"), [r"a \; b"]);
    assert_eq!(cut("t \\in [0,1)\ny"), ["t \\in [0,1)", "y"]);
    assert_eq!(cut("(($ $ $"), ["(($ $ $"]);
}

#[test]
fn incomplete_input() {
    for text in ["(", "f(a,", "a +", "F :=", "a = # b", "[1\n;", "t -", "x_", "$a", r"\begin{x}"] {
        assert!(is_incomplete(text), "{text}");
    }
    for text in ["", "a", "a)", "(a)", "# (", "a; b"] {
        assert!(!is_incomplete(text), "{text}");
    }
}

#[test]
fn latex_is_recognised() {
    for text in [r"\frac12", "$a$", r"t_1 \cdot t_2", r"\left(", r"a\,b", "\\"] {
        assert!(looks_like_latex(text), "{text}");
    }
    for text in ["t^2", r"\alpha + \Sigma", "α", "t_{12}^{2}", "", "polar(t)"] {
        assert!(!looks_like_latex(text), "{text}");
    }
}

/// Every kind of mistake with its message, to be read by a person in the snapshot.
#[test]
fn error_messages() {
    let mistakes = [
        "",
        "  # only a comment",
        "t + * 2",
        "t^2 +",
        "(t + 1",
        "t + 1)",
        "(t + 1]",
        "[0, 1)",
        "(t +",
        "f(a, b",
        "t ? 2",
        "* 2",
        "a + + b",
        "2^+1",
        "(t + )",
        "f(a,,b)",
        "f(a,)",
        "()",
        "(a,)",
        "(a, b; c)",
        "[1, , 2]",
        "a,",
        "(* 2)",
        "1.2.3",
        "t1.5",
        "t_1.5",
        "1e5",
        "2.5e-3",
        "2 3",
        "t^2 3",
        "|x",
        "{t | }",
        "a : b",
        "x if y",
        "t{2}",
        "n!!",
        "t_1_2",
        "t1_2",
        "2_3",
        "t_",
        "t_+ 1",
        "t_{}",
        "t^",
        "t^{}",
        "t^{1,2}",
        r"\frac{1}{2}",
        r"\foo",
        "a := b := c",
        "a = b := c",
        "0..n..2",
        "t+1 -> t",
        "(t, 2) -> t",
        "sum(i=0..n)",
        "sum(i=0..n, i, 2)",
        "prod(x in S)",
        "cases(1, 2)",
        "cases(1 if)",
        "√",
        "\"abc",
        "a \"b\" c $",
        "F\"",
        "t\na",
        "a; b",
        "²",
        "'",
        "f(t",
        "t̂^",
        "a ≠",
        "x \u{1} y",
        "⌊x",
        "_1",
        "a -> ",
        "..3",
        "(1..)",
        ".",
        "in S",
        "}",
    ];
    let mut text = String::new();
    for mistake in mistakes {
        let problem = parse(mistake).map(|expr| show(&expr)).expect_err(mistake);
        let span = problem.span.expect("every problem has a place");
        assert!(mistake.get(span.range()).is_some(), "{mistake}: {span:?}");
        assert!(problem.span == Some(Span::new(0, 0)) || !span.is_empty(), "{mistake}");
        assert!(!problem.hints.is_empty(), "{mistake}");
        writeln!(text, "{}\n", render(&problem, &SourceFile::new("<query>", mistake), false))
            .expect("strings take any text");
    }
    insta::assert_snapshot!(text);
}

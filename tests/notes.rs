//! The notes checker on files: the project's own notes, and the kinds of slips it is for.

use std::path::Path;

use polarform::document::Document;
use polarform::document::{Container, Reading, document, read_files};
use polarform::judge::finding::{Finding, Verdict};
use polarform::notes::{Options, check_document};
use polarform::source::SourceFile;

fn check(text: &str) -> Vec<Finding> {
    let document: Document = document(SourceFile::new("notes.md", text), Container::Markdown);
    let findings = check_document(&document, &Options::default()).findings;
    findings.into_iter().filter(|finding| finding.relation > 0).collect()
}

fn verdicts(text: &str) -> Vec<Verdict> {
    check(text).iter().map(|finding| finding.verdict).collect()
}

#[test]
fn the_project_s_own_notes_pass() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![root.join("README.md")];
    files.extend(std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()));
    files.retain(|path| path.extension().is_some_and(|e| e == "md"));
    for file in files {
        for document in read_files(&file, &Reading::default()).unwrap() {
            let report = check_document(&document, &Options::default());
            let wrong: Vec<&Finding> = report.findings.iter().filter(|f| f.is_suspicious()).collect();
            assert!(wrong.is_empty(), "{}: {wrong:#?}", file.display());
            assert!(report.problems.is_empty(), "{}: {:?}", file.display(), report.problems);
        }
    }
}

/// Each formula in the table of notations is read, or not, as the table says.
#[test]
fn the_notations_of_the_documentation() {
    let page = include_str!("../docs/notes.md");
    let table = page.split("## Notations").nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap();
    let mut tried = 0;
    for row in table.lines().filter(|line| line.contains('`') && line.starts_with("| ")) {
        let (name, examples) = row[2..].split_once(" | ").unwrap();
        for example in examples.split('`').skip(1).step_by(2) {
            let found = check(&format!("So ${example}$.\n"));
            assert!(!found.is_empty(), "{example}");
            let unread = found.iter().any(|finding| finding.verdict == Verdict::Unread);
            let judged = |finding: &Finding| {
                matches!(finding.verdict, Verdict::Definition | Verdict::Proved | Verdict::Sampled)
            };
            let kept = if name.starts_with("unread") { unread } else { found.iter().all(judged) };
            assert!(kept, "{name}: {example}: {found:#?}");
            tried += 1;
        }
    }
    assert!(tried >= 20, "{tried}");
}

#[test]
fn slips_are_found_and_repaired() {
    for (text, repair) in [
        (
            "Given $F(t) = t^2 + 2t$, $G(t) = t^3 + 1$, $f(t_1,t_2) = t_1t_2 + t_1 + t_2$, $g(t_1,t_2,t_3) = t_1t_2t_3 + 1$.\n\n\
             $$f(g(t_1,t_2,t_3), g(t_4,t_5,t_6)) = t_1t_2t_3t_4t_5t_6 + t_1t_2t_3 + t_4t_5t_6 + 1$$",
            "+ 3",
        ),
        (
            "$F(t) = \\sum_{i=0}^n c_i t^i$\n\n$$f(t_1,t_2,t_3) = c_0 + c_1\\frac{t_1+t_2+t_3}{3} + c_1\\frac{t_1t_2+t_1t_3+t_2t_3}{3} + c_3t_1t_2t_3$$",
            "c_2 \\frac{t_1 t_2",
        ),
        (
            "The polar form of a Bezier curve of degree n is\n\n$$f(t_1,\\ldots,t_n) = \\sum_{i=0}^n \\binom{n}{i} \\sigma_{i,n-i}(t_1,\\ldots,t_n)$$",
            "b_i",
        ),
        (
            "$$\\Phi(\\tau) = \\prod_{j=1}^n (t_j - \\tau)$$\n\nTherefore the polar form of F is\n\n$$f(t_1,\\ldots,t_n) = \\sum_{i=0}^n \\Phi^{(n-i)}(\\tau) F^{(i)}(\\tau)$$",
            "(-1)^{n-i}",
        ),
        (
            "$$B_i^n(t) = \\left(1-\\frac{i}{n+1}\\right)B_i^{n+1}(t) + \\frac{i+1}{n+1}B_{i-1}^{n+1}(t)$$",
            "B_{i+1}^{n+1}(t)",
        ),
        (
            "$B = \\{1, u, v, u^2, uv, v^2\\}$ has the polar forms\n\n$$B = \\{1, \\frac12(u_1+u_2), \\frac12(v_1+v_2), u_1u_2, \\frac14(u_1v_1+u_1v_2+u_2v_1+u_2v_2), v_1v_2\\}$$",
            "u_1 v_2",
        ),
    ] {
        let wrong: Vec<Finding> = check(text).into_iter().filter(|f| f.verdict == Verdict::Refuted).collect();
        assert_eq!(wrong.len(), 1, "{text}");
        let without_spaces = |text: &str| text.replace(' ', "");
        let suggestion = wrong[0].suggestion.as_deref().unwrap_or("none");
        assert!(without_spaces(suggestion).contains(&without_spaces(repair)), "{suggestion}");
        assert!(wrong[0].witness.is_some(), "{text}");
    }
}

#[test]
fn families_are_proved() {
    for text in [
        "$B_i^n(t) = (1-t) B_i^{n-1}(t) + t B_{i-1}^{n-1}(t)$",
        "$B_i^n(t) = B_{n-i}^n(1-t)$",
        "$\\frac{d}{dt} B_i^n(t) = n(B_{i-1}^{n-1}(t) - B_i^{n-1}(t))$",
        "$\\sum_{i=0}^n B_i^n(t) = 1$",
        "$\\binom{n}{k} = \\binom{n-1}{k} + \\binom{n-1}{k-1}$",
    ] {
        assert_eq!(verdicts(text), [Verdict::Proved], "{text}");
    }
}

/// What is given is not found to be something else in the same section; both places are told.
#[test]
fn contradictions_are_told() {
    let warned = |page: &str| -> Vec<String> {
        check(page)
            .into_iter()
            .filter_map(|finding| Some(format!("{}: {}", finding.latex, finding.warning?)))
            .collect()
    };
    for (page, told) in [
        ("Let $b_0=0$ and $b_3=11$.\n\nHence $b_3=10$.", "b_3 = 10: line 1 gives it the value 11"),
        (
            "The control points are $b_0=0$ and $b_1=2$.\n\nSince $b_1=3$, it rises.",
            "b_1 = 3: line 1 gives it the value 2",
        ),
        (
            "Gegeben seien $b_0=(0,0)$ und $b_1=(1,2)$. Also ist $b_1=(2,1)$.",
            "b_1 = (2,1): line 1 gives it the value (1, 2)",
        ),
    ] {
        assert_eq!(warned(page), [told], "{page}");
    }
    for page in [
        "# A curve\n\nLet $b_0=0$ and $b_3=11$.\n\n# Another curve\n\nHence $b_3=10$.",
        "Let $b_0=1$. For the second curve let $b_0=2$. So $b_0=2$.",
        "Let $n=2$. Hence $n=2$. If $n=3$, then $n+1=4$.",
        "**Example 1.** Let $b_0=1$.\n\n**Example 2.** Here $b_0=2$; hence $b_0=2$.",
    ] {
        assert_eq!(warned(page), [""; 0], "{page}");
    }
}

#[test]
fn conditions_and_equations_are_no_claims() {
    for text in [
        "$\\alpha + \\beta + \\gamma = 1$",
        "We solve $x^2 - 3x + 2 = 0$.",
        "The curves meet if $f(b,b) = g(b,b)$ and $f(b,c) = g(b,c)$.",
        "$S'(x_0) = m_0$",
        "$F(0) = 1$",
        "$t_{i+1} - t_i = h$",
        "$S(x_i - 0) = S(x_i + 0)$",
        "Let $x = y + z$. In the next example let $x = y - z$.",
        "$a = x_0 < x_1 < \\cdots < x_n = b$",
        "Take $M_0 = M_n = 0$.",
    ] {
        assert!(!verdicts(text).contains(&Verdict::Refuted), "{text}");
    }
}

#[test]
fn declarations_count() {
    let text = "<!-- polarform: F(t) := t^2 -->\n\n$F(3) = 10$\n\n<!-- polarform: ignore -->\n\n$F(3) = 11$\n\n$F(3) = 9$";
    assert_eq!(verdicts(text), [Verdict::Refuted, Verdict::Undecided, Verdict::Proved]);
    let options = Options { context: Some("G(t) := t + 1".to_owned()), ..Options::default() };
    let file = document(SourceFile::new("a.md", "$G(1) = 3$"), Container::Markdown);
    assert_eq!(check_document(&file, &options).findings[0].verdict, Verdict::Refuted);
}

#[test]
fn chains_go_on_in_the_next_formula() {
    let start = "$$(a+b)^2 = a^2+2ab+b^2 =$$\n\n";
    for next in ["$$(b-a)^2$$", "$$= (b-a)^2$$"] {
        assert_eq!(verdicts(&format!("{start}{next}")), [Verdict::Proved, Verdict::Refuted], "{next}");
    }
    assert_eq!(verdicts(&format!("{start}What follows is $c = (b-a)^2$."))[0], Verdict::Proved);
}

#[test]
fn formulas_of_doxygen() {
    assert_eq!(verdicts(r"So \f$1+1=2\f$ and \f[1+1=3\f]"), [Verdict::Proved, Verdict::Refuted]);
}

#[test]
fn one_unread_side_spoils_itself_only() {
    let findings = check("$$(t+1)^3 = \\unknowncommand{t} = t^3 + 3t^2 + 3t + 1 = t^3 + 3t^2 + 3t$$");
    let words: Vec<&str> = findings.iter().map(|finding| finding.verdict.word()).collect();
    // What is equal to the side before the unread one is not confirmed by courtesy.
    assert_eq!(words, ["unread", "undecided", "refuted"]);
}

#[test]
fn nothing_makes_it_panic() {
    for text in [
        "",
        "$$",
        "$",
        "$$\\frac{$$",
        "$a=$",
        "$=b$",
        "$\\begin{aligned} a &= \\\\ &= $",
        "$f(,) = g$",
        "$B_i^n = $ $B_{-1}^{-2}(t) = 0$",
        "$\\sum_{i=0}^{10^{9}} i = n$",
        "$n!!! = (((((((((n)))))))))$",
        "$f(\\ldots) = f(\\ldots, \\ldots)$",
        "$t_1 + \\cdots = \\cdots + t_n$",
        "$x^{x^{x^{x}}} = x$",
        "$9^{9^{9}} = 1$",
        "$\\binom{10^{12}}{5 \\cdot 10^{11}} = 1$",
        "$P_n(b_0,\\ldots; t) = \\Delta^{n} b_0$",
    ] {
        let _ = check(text);
    }
}

#[test]
fn blocks_of_queries_declare_names() {
    let block = "```polarform hide show=none\nf := polar(t^3)\nb := [1, 4, 5]\nq := polar_total(u v, [u, v], degree=2)\nf(0, 0, 1) = 7\n```\n";
    let hidden = format!("<!--\n{block}-->\n");
    let text = "\n$f(1, 1, 2) = 2$, $f(0, 1, \\hat 1) = 0$, $f(1, 1, 2) = 3$, $b_1 = 4$, $b_1 = 5$, \
                $q((u_1, v_1), (u_2, v_2)) = \\frac{1}{2} (u_1 v_2 + u_2 v_1)$, $F(0) = 1$\n";
    for block in [block.to_owned(), hidden] {
        let verdicts = verdicts(&format!("{block}{text}"));
        let [Verdict::Proved, Verdict::Proved, Verdict::Refuted, Verdict::Proved, wrong, Verdict::Proved, _] =
            verdicts[..]
        else {
            panic!("{block}: {verdicts:?}")
        };
        assert!(wrong != Verdict::Proved && wrong != Verdict::Sampled, "{block}: {verdicts:?}");
    }
    // A block that is never closed, or of another language, says nothing.
    for block in ["```python\nf := polar(t^3)\n```\n", "text\n\n    f := polar(t^3)\n"] {
        assert_ne!(verdicts(&format!("{block}\n$f(1, 1, 2) = 3$"))[0], Verdict::Refuted, "{block}");
    }
}

#[test]
fn queries_of_latex_are_read() {
    let text = "\\begin{document}\n\\begin{polarform}[hide]\nf := polar(t^2)\n\\end{polarform}\n\
                $f(1, 2) = \\polarform{f(1, 2)} = 2$ and $6 \\cdot \\polarform{f(1, 1) + 1} = 13$.\n\\end{document}\n";
    let document = document(SourceFile::new("a.tex", text), Container::Latex);
    let findings = check_document(&document, &Options::default()).findings;
    let verdicts: Vec<Verdict> = findings.iter().map(|finding| finding.verdict).collect();
    assert_eq!(verdicts, [Verdict::Proved, Verdict::Proved, Verdict::Refuted], "{findings:#?}");
}

#[test]
fn what_lecturers_write_is_no_false_alarm() {
    for text in [
        "$f(t_1, t_2, \\dots, t_n) = f(t_2, t_1, \\dots, t_n)$",
        "$f(t_1, \\dots, t_n) = f(t_n, t_1, \\dots, t_{n-1})$",
        "- $f((1 - \\lambda) r + \\lambda s, u, v) = (1 - \\lambda) f(r, u, v) + \\lambda f(s, u, v)$",
        "$\\frac{1}{3} (t_1 t_2 + \\cdots + t_2 t_3) = \\frac{t_1 t_2 + t_1 t_3 + t_2 t_3}{3}$",
        "$t_1 t_2 + \\cdots + t_3 t_4 = t_1 t_2 + t_2 t_3 + t_3 t_4$",
        "$\\frac{d}{dt} B_0^3(t) \\Big|_{t=0} = -3$",
        "With $x(0)$: $B_i^{n}(x) = C^i_n x^i(1-x)^{n-i}$",
    ] {
        let verdicts = verdicts(text);
        assert!(matches!(verdicts[..], [Verdict::Proved | Verdict::Sampled]), "{text}: {verdicts:?}");
    }
    for text in [
        // What is counted with the letter of B-splines; a range without an end.
        "$N_{i,k}$ counts the subsets: $N_{i,k}=N_{i-1,k-1}+N_{i-1,k}$. Hence $$N_{m+n,k}=\\sum_{j=0}^{k}N_{m,j}\\,N_{n,k-j}.$$",
        "From $e_{k+1}=a e_k+b$ we get $$e_k=e^*+a^k\\,(e_0-e^*),\\qquad k=0,1,2,\\dots$$ with $e^*=b/(1-a)$, and $$\\frac{e_{k+2}-e_{k+1}}{e_{k+1}-e_k}=a .$$",
    ] {
        let verdicts = verdicts(text);
        assert!(!verdicts.contains(&Verdict::Refuted), "{text}: {verdicts:?}");
    }
    let text = "$x(t) = \\frac{1-t^2}{1+t^2}$, $y(t) = \\frac{2t}{1+t^2}$. So $x(t)^2 + y(t)^2 = 1$ and $x(t)^2 = 1$.";
    let last: Vec<Verdict> = verdicts(text).split_off(2);
    assert!(matches!(last[..], [Verdict::Proved, Verdict::Refuted | Verdict::Undecided]), "{last:?}");
}

/// What the last formula of a page is, by the words and formulas before it.
#[test]
fn pages_mean_what_they_say() {
    let green = ["proved", "sampled"].as_slice();
    let red = ["refuted"].as_slice();
    let silent = ["undecided", "definition", "unread"].as_slice();
    let mut wrong = Vec::new();
    for (page, wanted) in [
        // What is unknown means nothing.
        ("$D(p,q,r)=D(q,p,r)$", silent),
        ("$S(n,k)=S(k,n)$", silent),
        ("$C(n,k)=C(n-1,k)+C(n-1,k-1)$", silent),
        ("$I(m,n)=\\frac{n}{m+1}I(m+1,n-1)$", silent),
        ("$$\\sum_{k=0}^\\infty x^k=\\frac{1-x^9}{1-x}$$", silent),
        ("$x=x+1$", red),
        ("$b_i=b_i+1$", red),
        // Objects in words.
        (
            "Let $F$ be a polynomial of degree $n$ and $f$ its polar form. Then $F'(t)=n f(t,\\dots,t,\\hat 1)$.",
            green,
        ),
        (
            "Let $F$ be a polynomial of degree $n$ and $f$ its polar form. Then $F'(t)=(n-1) f(t,\\dots,t,\\hat 1)$.",
            red,
        ),
        ("Let $F$ be a polynomial of degree $n$, $f$ its polar form. Then $F(t)=f(t^n)$.", green),
        ("Let $F$ be a polynomial of degree $n$, $f$ its polar form. Then $F(t)=f(t^{[n]})$.", green),
        ("Let $F$ be a polynomial of degree $n$, $f$ its polar form. Then $F(t)=2f(t^{[n]})$.", red),
        ("Let $f$ be the polar form of a cubic $F$. Then $F'''(t)=f(\\hat 1,\\hat 1,\\hat 1)$.", red),
        (
            "Let $F$ be quadratic and $g$ be affine. Let $h$ be the polar form of $Fg$ and $f$ the polar form of $F$. Then $h(a,b,c)=\\frac13(f(a,b)g(c)+f(a,c)g(b)+f(b,c)g(a))$.",
            green,
        ),
        ("Let $N$ be the quadratic B-spline with the knots $0,1,2,3$. Then $N(\\frac32)=\\frac34$.", green),
        ("Let $N$ be the quadratic B-spline with the knots $0,1,2,3$. Then $N(\\frac32)=\\frac23$.", red),
        (
            "Let $N_i$ be the quadratic B-spline with the knots $i,i+1,i+2,i+3$. Then $\\sum_i N_i(t)=1$.",
            green,
        ),
        (
            "Let $N_i^n$ be the B-spline of degree $n$ with the knots $t_i,\\dots,t_{i+n+1}$. Then $\\int_{\\mathbb R}N_i^n(t)\\,dt=\\frac{t_{i+n+1}-t_i}{n+1}$.",
            green,
        ),
        (
            "Let $L_0,\\dots,L_n$ be the Lagrange polynomials of $x_0,\\dots,x_n$. Then $\\sum_{i=0}^n L_i(x)=1$.",
            green,
        ),
        (
            "The polar form of $t^k$ as a polynomial of degree $n$ is $$f(t_1,\\dots,t_n)=\\binom nk^{-1}\\sum_{1\\le i_1<\\dots<i_k\\le n}t_{i_1}\\cdots t_{i_k}.$$",
            green,
        ),
        // Facts determine names, if the page says of which kind they are.
        (
            "We need $c_0=b_3$ and $c_1-c_0=b_3-b_2$ and also $$c_2-2c_1+c_0=b_3-2b_2+b_1.$$ Hence $$c_2=b_1-4b_2+4b_3.$$",
            green,
        ),
        (
            "We need $c_0=b_3$ and $c_1-c_0=b_3-b_2$ and also $$c_2-2c_1+c_0=b_3-2b_2+b_1.$$ Hence $$c_2=b_1-4b_2+3b_3.$$",
            red,
        ),
        ("Let $S$ be a spline with $S(x_i)=y_i$. Natural ends are $S''(x_0)=S''(x_n)$.", silent),
        ("Let $F_0=0$, $F_1=1$ and $F_{n+1}=F_n+F_{n-1}$. Then $F_{n+1}F_{n-1}-F_n^2=(-1)^n$.", green),
        ("Let $F_0=0$, $F_1=1$ and $F_{n+1}=F_n+F_{n-1}$. Then $F_{n+1}F_{n-1}-F_n^2=(-1)^{n+1}$.", red),
        (
            "The cubic polynomial $p$ has $p(0)=1$, $p'(0)=2$, $p(1)=0$ and $p'(1)=-1$. We write $p(t)=1+2t+\\alpha t^2+\\beta t^3$.",
            silent,
        ),
        (
            "The cubic polynomial $p$ has $p(0)=1$, $p'(0)=2$, $p(1)=0$ and $p'(1)=-1$. Hence $p(t)=1+2t-6t^2+3t^3$.",
            green,
        ),
        ("$f(t)=\\binom10(1-t)^2+\\binom01t^2$, so $f(t)=t$.", silent),
        // Cases and ranges.
        ("For $n=2$ we have $\\sum_{i=0}^n i=3$.", green),
        ("$$\\sum_{k=0}^n(-1)^k=\\begin{cases}1,&n\\text{ even},\\\\0,&n\\text{ odd}\\end{cases}$$", green),
        (
            "$$\\sum_{k=0}^n(-1)^k=\\begin{cases}0,&\\text{falls $n$ gerade},\\\\1,&\\text{sonst}\\end{cases}$$",
            red,
        ),
        ("For all $x$ we have $(1+x)^3\\ge 1+3x$.", silent),
        ("For $t=0$ we get $(1-t)^2=1$.\n\n## More\n\nAlways $(1-t)^2=1$.", red),
        ("For all $t$ we have $(1-t)^2=1-2t+t^2$.", green),
        ("Solving $x^2=1$ is easy.", silent),
        // What the field knows, under the words of the section.
        (
            "## Raising the degree\n\nA curve of degree $n$ has as one of degree $n+1$ the points $$c_i=\\frac{i}{n+1}b_{i-1}+\\frac{n+1-i}{n+1}b_i.$$",
            green,
        ),
        (
            "## Graderhöhung\n\nEine Kurve vom Grad $n$ hat als solche vom Grad $n+1$ die Punkte $$c_i=\\frac{i}{n}b_{i-1}+\\left(1-\\frac{i}{n}\\right)b_i.$$",
            red,
        ),
        (
            "## Élévation du degré\n\n$$\\hat b_i=\\left(1-\\frac{i}{n+1}\\right)b_{i-1}+\\frac{i}{n+1}b_i$$",
            red,
        ),
        ("Let $$c_i=\\left(1-\\frac{i}{n+1}\\right)b_{i-1}+\\frac{i}{n+1}b_i.$$", silent),
        ("Knot insertion for splines of degree $p$: $$\\alpha_i=\\frac{\\bar u-u_i}{u_{i+p}-u_i}.$$", green),
        ("Knot insertion for splines of degree $p$: $$\\alpha_i=\\frac{\\bar u-u_i}{u_{i+p+1}-u_i}.$$", red),
        (
            "Splines, where $k$ is the order. In de Boor's algorithm $$\\alpha_i^r=\\frac{x-t_i}{t_{i+k-r}-t_i}.$$",
            green,
        ),
        (
            "Splines, where $k$ is the degree. In de Boor's algorithm $$\\alpha_i^r=\\frac{x-t_i}{t_{i+k-r}-t_i}.$$",
            red,
        ),
        (
            "在升阶中，曲线的新控制点是 $$c_i=\\frac{i}{n+1}b_{i-1}+\\left(1-\\frac{i}{n+1}\\right)b_i。$$",
            green,
        ),
        (
            "Let $C(t)=\\sum_{i=0}^nP_iB_i^n(t)$ with $n\\ge2$. Then $C''(1)=n(n-1)(P_n-2P_{n-1}+P_{n-2})$.",
            green,
        ),
        (
            "Let $C(t)=\\sum_{i=0}^nP_iB_i^n(t)$ with $n\\ge2$. Then $C''(1)=n(n-1)(P_n-2P_{n-1}-P_{n-2})$.",
            red,
        ),
        // Values in words.
        (
            "The knots $t_0,\\dots,t_7$ are $0,0,0,1,2,3,3,3$. The ratio is $\\frac{3/2-t_2}{t_4-t_2}=\\frac34$.",
            green,
        ),
        (
            "The knots $t_0,\\dots,t_7$ are $0,0,0,1,2,3,3,3$. The ratio is $\\frac{3/2-t_2}{t_4-t_2}=\\frac12$.",
            red,
        ),
        ("With some knots $\\frac{3/2-t_2}{t_4-t_2}=\\frac12$.", silent),
        ("The cubic $p$ has the control points $1,2,4,3$. Then $p'(0)=3$.", green),
        ("The cubic $p$ has the control points $1,2,4,3$. Then $p'(1)=3$.", red),
        // Sums and extreme values.
        ("Let $p_{n,k}(x)=\\binom nk x^k(1-x)^{n-k}$. Then $\\sum_k k\\,p_{n,k}(x)=nx$.", green),
        ("$$\\max_{0\\le t\\le1}B_1^2(t)=\\frac13$$", red),
        ("$$\\max_{0\\le t\\le1}B_1^2(t)=\\frac12$$", green),
        ("$$\\max_{0\\le t\\le1}t(1-t)(2-t)=\\frac13$$", red),
        (
            "Let $F$ be affine with polar form $f$, let $G$ be quadratic with polar form $g$. The product $H=FG$ is cubic, and $$h(a,b,c)=\\frac13(f(a)g(b,c)+f(b)g(a,c)+f(c)g(a,b)).$$",
            green,
        ),
        ("For all $x$ we have $(1+x)^2\\ge 1+2x$.", green),
        ("$B_i^n(t)\\ge 0$ for $0\\le t\\le 1$.", green),
        ("Is it true that $(a+b)^2=a^2+b^2$?", silent),
    ] {
        let findings = check(page);
        let claim = findings
            .iter()
            .rfind(|finding| finding.relation > 0 && finding.reason.as_deref() != Some("a condition"));
        let word = claim.map_or("nothing", |finding| finding.verdict.word());
        if !wanted.contains(&word) {
            wrong.push(format!("{page}\n    {word}: {:?}", claim.map(|finding| &finding.reason)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn suggestions_are_in_the_words_of_the_author() {
    for (text, suggestion) in [
        (
            "Let $\\mathbf{C}(t)=\\sum_{i=0}^{n}\\mathbf{P}_iB_{i,n}(t)$. Then\n\n$$\\mathbf{C}'(t)=n\\sum_{i=0}^{n-1}(\\mathbf{P}_{i}-\\mathbf{P}_{i+1})\\,B_{i,n-1}(t)$$",
            "\\mathbf{C}'(t)=n\\sum_{i=0}^{n-1}(\\mathbf{P}_{i+1}-\\mathbf{P}_{i})\\,B_{i,n-1}(t)",
        ),
        (
            "$$\\begin{aligned}B_i^n(t)&=\\Bigl(1-t\\Bigr)\\,B_i^{n-1}(t)\\\\&\\quad+t\\,B_{i+1}^{n-1}(t)\\end{aligned}$$",
            "B_i^n(t) =\\Bigl(1-t\\Bigr)\\,B_i^{n-1}(t) \\quad+t\\,B_{i-1}^{n-1}(t)",
        ),
        (
            "$$\\int_0^1 B_{i,n}(t)\\,\\mathrm dt=\\frac 1 n$$",
            "\\int_0^1 B_{i,n}(t)\\,\\mathrm dt=\\frac 1 {n+1}",
        ),
    ] {
        let wrong: Vec<Finding> = check(text).into_iter().filter(|f| f.verdict == Verdict::Refuted).collect();
        assert_eq!(wrong.len(), 1, "{text}");
        assert_eq!(wrong[0].suggestion.as_deref(), Some(suggestion));
    }
}

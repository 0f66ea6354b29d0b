//! One case for each construct: what is written, and its tree.

use super::sexpr::sexpr;
use crate::language::latex::read;

#[track_caller]
fn check(cases: &[(&str, &str)]) {
    for (text, tree) in cases {
        match read(text) {
            Ok(expr) => assert_eq!(sexpr(&expr), *tree, "{text}"),
            Err(problem) => panic!("{text}: {problem:?}"),
        }
    }
}

#[test]
fn names_and_numbers() {
    check(&[
        ("t", "t"),
        ("ab", "(* a b)"),
        (r"\alpha\beta", "(* alpha beta)"),
        (r"\varphi", "varphi"),
        (r"\ell + \pi", "(+ ell pi)"),
        (r"\infty", "infty"),
        (r"\operatorname{area}", "area"),
        (r"\operatorname { area } ( T )", "(area: T)"),
        (r"\mathrm{d}", "d"),
        (r"\mathrm { a r e a }", "area"),
        (r"\mathrm{F(t)}", "(F: t)"),
        ("12", "12"),
        ("0.25", "1/4"),
        (".5t", "(* 1/2 t)"),
        ("1.", "1"),
        ("1{,}5", "3/2"),
        (r"10\,000", "10000"),
        ("t = 2.", "(t = 2)"),
        ("2t", "(* 2 t)"),
        ("c t t", "(* c t t)"),
        (r"\part", "partial"),
        ("t_{i+1} = constant", "((_ t (+ i 1)) = constant)"),
    ]);
}

#[test]
fn unicode() {
    check(&[
        ("σ₁₂", "(_ sigma 12)"),
        ("t³ + u₁", "(+ (^ t 3) (_ u 1))"),
        ("tⁿ⁺¹", "(^ t (+ n 1))"),
        ("F⁽ᵏ⁾(t)", "((upper F k): t)"),
        ("b₀₁", "(_ b 01)"),
        ("f: ℝ → ℝ^d", "(f : (bb R) → (^ (bb R) d))"),
        ("a · b × c", "(* a (x b c))"),
        ("∑_{i=0}^n aᵢ ≤ 1", "((sum ((i = 0)) n (_ a i)) ≤ 1)"),
        ("∑ᵢ aᵢ", "(sum (i) _ (_ a i))"),
        ("F∘G ≠ G∘F", "((o F G) ≠ (o G F))"),
        ("∀x∈U", "(all ((x ∈ U)) _)"),
        ("𝑡² + 𝛼", "(+ (^ t 2) alpha)"),
        ("𝐛 + 𝒅ᵢ", "(+ (bold b) (_ (bold d) i))"),
        ("F´(t)", "((' F): t)"),
        ("F\"(t)", "(('' F): t)"),
        ("√2", "(sqrt: 2)"),
        ("√(x+1)", "(sqrt: [(+ x 1)])"),
        ("a − b", "(+ a (- b))"),
        ("f(t₁，t₂)", "(f: (_ t 1) (_ t 2))"),
        ("F′(t)", "((' F): t)"),
        ("u ≔ 1", "(u := 1)"),
    ]);
}

#[test]
fn scripts() {
    check(&[
        ("t_1", "(_ t 1)"),
        ("t _ { 1 2 }", "(_ t 12)"),
        ("t_{12}", "(_ t 12)"),
        ("b_{01}+b_{00}", "(+ (_ b 01) (_ b 00))"),
        ("b _ { 0 1 }", "(_ b 01)"),
        ("p_{i,j}", "(_ p i j)"),
        ("p_{0 , m - d + 1}", "(_ p 0 (+ m (- d) 1))"),
        ("u_{ij}", "(_ u (* i j))"),
        ("x_i^{(k)}", "(upper (_ x i) k)"),
        ("x_i^{(j,k)}", "(upper (_ x i) j k)"),
        ("f^{(+1)}", "(upper f (+ 1))"),
        ("B_i^n", "(^ (_ B i) n)"),
        ("B^n_i", "(^ (_ B i) n)"),
        ("t^1 0", "(* (^ t 1) 0)"),
        ("t^{10}", "(^ t 10)"),
        ("A^{-1}", "(^ A (+ (- 1)))"),
        ("F'", "(' F)"),
        ("F''", "('' F)"),
        (r"F^{\prime}", "(' F)"),
        (r"F ^ { \prime \prime } ( t )", "(('' F): t)"),
        (r"F^\prime", "(' F)"),
        ("f'_0", "(' (_ f 0))"),
        ("S''_i(x)", "(('' (_ S i)): x)"),
        ("f'^2", "(^ (' f) 2)"),
        (r"A^\top", "(T A)"),
        (r"A^{\mathrm T}", "(T A)"),
        (r"A^{\mathsf{T}}", "(T A)"),
        (r"A^{\rm T}", "(T A)"),
        ("A^T", "(^ A T)"),
        ("[1, 0]^T", "(T (list 1 0))"),
        (r"f^*+f^\ast+f^{*}", "(+ (^ f ast) (^ f ast) (^ f ast))"),
        (r"45^\circ", "(^ 45 circ)"),
        (r"x_{\text{max}}", "(_ x max)"),
        (r"f^{(\text {hom })}", "(upper f hom)"),
        (r"(x)^\frac 3 2", "(^ [x] (frac 3 2))"),
        ("x_{}", "x"),
        ("x^{n!}", "(^ x (! n))"),
        ("x^{y^{z}}", "(^ x (^ y z))"),
        (r"\{x_i\}_{i=1}^n", "(^ (_ (set (_ x i)) (i = 1)) n)"),
    ]);
}

#[test]
fn application_or_product() {
    check(&[
        ("f(t+1)", "(f: (+ t 1))"),
        (r"f\left( t \right)", "(f: t)"),
        (r"f\bigl(t\bigr)", "(f: t)"),
        (r"f\big(g(t)\big)", "(f: (g: t))"),
        ("f(u_1, u_2; v)", "(f: (_ u 1) (_ u 2) ; v)"),
        ("f()", "(f: )"),
        (r"f(\cdot,\cdot)", "(f: cdot cdot)"),
        (r"\pmb{f}(t)", "((bold f): t)"),
        ("B_i^n(t)", "((^ (_ B i) n): t)"),
        ("B_i^2(u)", "((^ (_ B i) 2): u)"),
        ("F^{(k)}(t)", "((upper F k): t)"),
        ("f^*(t)", "((^ f ast): t)"),
        ("t^2(t+1)", "(* (^ t 2) [(+ t 1)])"),
        ("A^{-1}(b)", "(* (^ A (+ (- 1))) [b])"),
        ("2(t+1)", "(* 2 [(+ t 1)])"),
        ("(1-u)(1-v)", "(* [(+ 1 (- u))] [(+ 1 (- v))])"),
        (r"\frac{1}{2}(a+b)", "(* (frac 1 2) [(+ a b)])"),
        ("(f+g)(t_1, t_2)", "([(+ f g)]: (_ t 1) (_ t 2))"),
        ("(f+g)(t)", "([(+ f g)]: t)"),
        ("(f+1)(t)", "(* [(+ f 1)] [t])"),
        (r"(F\circ G)(t)", "([(o F G)]: t)"),
        (r"(F\circ G)'(t)", "((' [(o F G)]): t)"),
        (r"\det\begin{pmatrix} a \end{pmatrix}", "(det: (pmatrix a))"),
        ("f(t)(1-t)", "(* (f: t) [(+ 1 (- t))])"),
        (r"t_{\pi(1)}", "(_ t (pi: 1))"),
        ("f(0^{n-i}1^i)", "(f: (* (^ 0 (+ n (- i))) (^ 1 i)))"),
        (r"A\left(\begin{matrix} a \\ b \end{matrix}\right)", "(* A (pmatrix a / b))"),
        (r"\text{area}(T)", "(area: T)"),
        (r"span\{f_1, f_2\}", "(span: (set (_ f 1) (_ f 2)))"),
        ("f[x_0, x_1](x)", "(* f (list (_ x 0) (_ x 1)) [x])"),
        (r"\sin(x)\cos x", "(* (sin: x) (cos: x))"),
        (r"a \cos kx + b", "(+ (* a (cos: (* k x))) b)"),
        (r"\sin^2 x", "((^ sin 2): x)"),
        (r"\log_2 n", "((_ log 2): n)"),
        (r"\det A", "(det: A)"),
        (r"k \to \inf", "(k → inf)"),
        (
            r"\hat{v}_i = p_i-q_i(i=1,\dots,k)",
            "(seq ((_ (hat v) i) = (+ (_ p i) (- (_ q i)))) (tuple (i = 1) … k))",
        ),
        (r"\phi(t)(a \le t \le b)", "(seq (phi: t) [(a ≤ t ≤ b)])"),
    ]);
}

#[test]
fn brackets() {
    check(&[
        ("(a)", "[a]"),
        ("(a,b)", "(tuple a b)"),
        ("[a,b]", "(list a b)"),
        ("[a+b]c", "(* [(+ a b)] c)"),
        (r"\left[f(t,t,1)-f(t,t,0)\right]", "[(+ (f: t t 1) (- (f: t t 0)))]"),
        (r"\{a,b\}", "(set a b)"),
        (r"\{\}", "(set )"),
        (r"2\left\{a + b\right\}", "(* 2 [(+ a b)])"),
        (r"\{x | x > 0\}", "(set x | (x > 0))"),
        (r"\{x \mid |x| > 0\}", "(set x | ((abs x) > 0))"),
        (r"\left\{x \middle| x > 0\right\}", "(set x | (x > 0))"),
        (r"\{x : x > 0\}", "(set x | (x > 0))"),
        (r"\{\sum a_i x_i | a_i \in R\}", "(set (sum () _ (* (_ a i) (_ x i))) | ((_ a i) ∈ R))"),
        ("[0, 1)", "(rightopen: 0 1)"),
        ("(0, 1]", "(leftopen: 0 1)"),
        ("|x|", "(abs x)"),
        (r"\left|x\right|", "(abs x)"),
        (r"\lvert x\rvert", "(abs x)"),
        ("|a||b|", "(* (abs a) (abs b))"),
        ("|a - |b||", "(abs (+ a (- (abs b))))"),
        ("||x+y||", "(norm (+ x y))"),
        (r"\| x \|", "(norm x)"),
        (r"c\|x\|\|y\|", "(* c (norm x) (norm y))"),
        (r"\left\|x\right\|", "(norm x)"),
        (r"|| \cdot ||", "(norm cdot)"),
        (r"\lfloor n/2 \rfloor", "(floor (/ n 2))"),
        (r"\left\lceil x\right\rceil", "(ceil x)"),
        (r"\langle f, g\rangle", "(inner: f g)"),
        ("<f, g> = 0", "((inner: f g) = 0)"),
        ("|S|=i", "((abs S) = i)"),
        (r"\left.a+b\right.c", "(* [(+ a b)] c)"),
    ]);
}

#[test]
fn values_at_a_point() {
    check(&[
        (r"\left. X \right|_{t=0}", "(at X ((t = 0)) _)"),
        (r"\frac{dF}{dt}\Big|_{t=0}", "(at (d (t) F) ((t = 0)) _)"),
        (r"n t^2 \bigg|_{t=0} b", "(* (at (* n (^ t 2)) ((t = 0)) _) b)"),
        ("a + X|_{t=1}", "(+ a (at X ((t = 1)) _))"),
        (r"\frac{d}{dt} F(t)\Big|_{t=0}", "(at (d (t) (F: t)) ((t = 0)) _)"),
        (r"\frac{d}{dt} a F(t)\Big|_{t=0}", "(at (d (t) (* a (F: t))) ((t = 0)) _)"),
        (r"X\Big|_t = 1", "((at X (t) _) = 1)"),
        ("[F(t)]_0^1", "(at [(F: t)] (0) 1)"),
        (r"\left. F \right|_0^1", "(at F (0) 1)"),
        (r"\left. F \right|_{u=0, v=1}", "(at F ((u = 0) (v = 1)) _)"),
    ]);
}

#[test]
fn arithmetic() {
    check(&[
        ("a - b + c", "(+ a (- b) c)"),
        ("-a", "(+ (- a))"),
        ("+1", "(+ 1)"),
        ("a + -b", "(+ a (+ (- b)))"),
        (r"a \cdot b * c", "(* a b c)"),
        ("a/b c", "(* (/ a b) c)"),
        ("a b/c d", "(* (/ (* a b) c) d)"),
        ("1/2 (a+b)", "(* (/ 1 2) [(+ a b)])"),
        (r"F \circ G", "(o F G)"),
        (r"u \times v", "(x u v)"),
        (r"2 u \times v", "(* 2 (x u v))"),
        (r"\mathbb{R}^{d\times m}", "(^ (bb R) (x d m))"),
        ("n!", "(! n)"),
        ("3 ! t", "(* (! 3) t)"),
        ("(n-k)!", "(! [(+ n (- k))])"),
        ("i!j!", "(* (! i) (! j))"),
        (r"\sqrt{2 \pi}", "(sqrt: (* 2 pi))"),
        (r"\sqrt2x", "(* (sqrt: 2) x)"),
        (r"\sqrt[3]{x}", "(root: x 3)"),
        (r"A \setminus B", "(setminus: A B)"),
        (r"2 \cdot \frac12", "(* 2 (frac 1 2))"),
        (r"2\frac{a}{b}", "(* 2 (frac a b))"),
        (r"2\frac{1}{n}", "(* 2 (frac 1 n))"),
        (r"2\frac32", "(* 2 (frac 3 2))"),
        (r"2^3\frac12\frac34", "(* (^ 2 3) (frac 1 2) (frac 3 4))"),
    ]);
}

#[test]
fn fractions_and_binomials() {
    check(&[
        (r"\frac{a}{b}", "(frac a b)"),
        (r"\frac { 3 ! } { 2 ! }", "(frac (! 3) (! 2))"),
        (r"\frac 3 2", "(frac 3 2)"),
        (r"\frac12", "(frac 1 2)"),
        (r"\frac123", "(* (frac 1 2) 3)"),
        (r"\frac{1}2t", "(* (frac 1 2) t)"),
        (r"\dfrac ab + \tfrac{a}b + \cfrac{1}{2}", "(+ (frac a b) (frac a b) (frac 1 2))"),
        (r"\frac\mu\sigma", "(frac mu sigma)"),
        (r"{a + b \over c}", "(frac (+ a b) c)"),
        (r"2{a \over b}^2", "(* 2 (^ (frac a b) 2))"),
        (r"\binom{n}{i}", "(binom n i)"),
        (r"\dbinom ni \tbinom{n}i", "(* (binom n i) (binom n i))"),
        (r"{n \choose i}", "(binom n i)"),
        (r"\left({n-1 \choose i}\right)", "[(binom (+ n (- 1)) i)]"),
        ("C_n^i", "(C n i)"),
        ("C^i_n", "(C n i)"),
        ("C_{n-i}^n(1-t)", "(* (C (+ n (- i)) n) [(+ 1 (- t))])"),
        ("C^k", "(^ C k)"),
        ("C^{(k)}_n", "(upper (_ C n) k)"),
    ]);
}

#[test]
fn derivatives_and_integrals() {
    check(&[
        (r"\frac{d}{dt} F(t)", "(d (t) (F: t))"),
        (r"\frac{d^k}{dt^k}F(t)", "(d (t^k) (F: t))"),
        (r"\frac{\mathrm d F}{\mathrm d t}", "(d (t) F)"),
        (r"\frac{dB_i^n(t)}{dt}", "(d (t) ((^ (_ B i) n): t))"),
        (r"\frac { \mathbb{d} ^ { k } } { \mathbb{d} t ^ { k } } F", "(d (t^k) F)"),
        (r"\frac{\partial^{r+s}}{\partial u^r\partial v^s} F", "(∂ (u^r v^s) F)"),
        (r"\frac{\part f}{\part u}", "(∂ (u) f)"),
        (r"\frac{\partial f}{\partial t_1}", "(∂ ((_ t 1)) f)"),
        (r"\left(\frac{d}{du} b_i\right)(u)", "([(d (u) (_ b i))]: u)"),
        (r"\left(\frac{d}{dt}\right)^2", "(^ [(d (t) _)] 2)"),
        (r"\frac{d^2}{dt^2}\Big|_{t=0} F(t)", "(* (at (d (t^2) _) ((t = 0)) _) (F: t))"),
        (r"\frac{dP}{dt}(0)", "((d (t) P): 0)"),
        (r"\frac{{\rm d}F}{{\rm d}t}", "(d (t) F)"),
        (r"\frac{d}{2}", "(frac d 2)"),
        (r"\frac{d+1}{d}", "(frac (+ d 1) d)"),
        (r"\frac{d_1}{d_2}", "(frac (_ d 1) (_ d 2))"),
        (r"\frac{d!}{i!}", "(frac (! d) (! i))"),
        (r"\frac{1}{d+1}", "(frac 1 (+ d 1))"),
        (r"\int_0^1 f(t)\,dt", "(int 0 1 (f: t) t)"),
        (r"\int f \mathrm{d}t + 1", "(+ (int _ _ f t) 1)"),
        (r"\int_a^b f(x)g(x) dx = c", "((int a b (* (f: x) (g: x)) x) = c)"),
        (r"\int_0^1 (a + t)\,d\tau", "(int 0 1 [(+ a t)] tau)"),
        (r"\int_0^1\int_0^1 u v\,du\,dv", "(int 0 1 (int 0 1 (* u v) u) v)"),
        (r"\int dt", "(int _ _ 1 t)"),
        (r"\int_0^1 dt\, f(t)", "(int 0 1 (f: t) t)"),
        (r"\dot P + \ddot{P}", "(+ (dot P) (ddot P))"),
    ]);
}

#[test]
fn accents() {
    check(&[
        (r"\hat{1}", "(hat 1)"),
        (r"\widehat{1}\hat 1", "(* (hat 1) (hat 1))"),
        (r"\vec v + \overrightarrow{u}", "(+ (vec v) (vec u))"),
        (r"\overrightarrow{x}_i", "(_ (vec x) i)"),
        (r"\overrightarrow{x_i}", "(vec (_ x i))"),
        (r"\bar a \overline{b} \tilde c", "(* (bar a) (bar b) (tilde c))"),
        (r"\dot{P}_n(0)", "((_ (dot P) n): 0)"),
        (r"\pmb{b}_0", "(_ (bold b) 0)"),
        (r"\pmb{b_0}", "(bold (_ b 0))"),
        (r"\boldsymbol { p }", "(bold p)"),
        (r"\mathbf b \bm{c}", "(* (bold b) (bold c))"),
        (r"p_{\pmb\alpha}", "(_ p (bold alpha))"),
        (r"\hat{\pmb{1}}", "(hat (bold 1))"),
        (r"\mathcal P(u)", "((script P): u)"),
        (r"\mathbb R^d", "(^ (bb R) d)"),
        (r"{\bf x}_i", "(_ (bold x) i)"),
        (r"\hat12", "(* (hat 1) 2)"),
    ]);
}

#[test]
fn ellipses_and_braces() {
    check(&[
        (r"t_1,\ldots,t_n", "(seq (_ t 1) … (_ t n))"),
        ("f(t_1,...,t_n)", "(f: (_ t 1) … (_ t n))"),
        ("f(t, . . . , t)", "(f: t … t)"),
        (r"t_1+\cdots+t_n", "(+ (_ t 1) … (_ t n))"),
        (r"t_1\cdots t_n", "(* (_ t 1) … (_ t n))"),
        (r"x_0 < \dots < x_n", "((_ x 0) < … < (_ x n))"),
        (r"\underbrace{t,\ldots,t}_{n-k}", "(brace (t … t) (+ n (- k)))"),
        (r"f(\underbrace{t,\dots,t}_i,\underbrace{\hat 1}_k)", "(f: (brace (t … t) i) (brace ((hat 1)) k))"),
        (r"\overbrace{a+b}^{n\text{ times}}", "(brace ((+ a b)) (seq n \"times\"))"),
        ("i = 0..n", "(i = (.. 0 n))"),
        ("a_1,..,a_n", "(seq (_ a 1) … (_ a n))"),
    ]);
}

#[test]
fn sums_and_products() {
    check(&[
        (r"\sum_{i=0}^n c_i t^i", "(sum ((i = 0)) n (* (_ c i) (^ t i)))"),
        (r"\sum^n_{i=0} c_i", "(sum ((i = 0)) n (_ c i))"),
        (r"\sum_i^n c_i", "(sum (i) n (_ c i))"),
        (r"\sum a_i x_i = 1", "((sum () _ (* (_ a i) (_ x i))) = 1)"),
        (r"\sum_j a_j u_j + 1", "(+ (sum (j) _ (* (_ a j) (_ u j))) 1)"),
        (r"\sum_{i+j+k=n} B", "(sum (((+ i j k) = n)) _ B)"),
        (r"\sum_{S\subseteq\{1,\dots,n\},|S|=i} x", "(sum ((S ⊆ (set 1 … n)) ((abs S) = i)) _ x)"),
        (r"\sum_\limits{k=1}^n t_k", "(sum ((k = 1)) n (_ t k))"),
        (r"\sum\limits_{k=1}^{n} t_k", "(sum ((k = 1)) n (_ t k))"),
        (r"\sum_{\substack{i+j=n\\ i,j\ge0}} x", "(sum (((+ i j) = n) i (j ≥ 0)) _ x)"),
        (r"\sum_{i+j=d\\i\ge0} x", "(sum (((+ i j) = d) (i ≥ 0)) _ x)"),
        (r"\prod_{j\in S}t_j", "(prod ((j ∈ S)) _ (_ t j))"),
        (r"\prod_1^n (t_i - \tau)", "(prod (1) n [(+ (_ t i) (- tau))])"),
        (r"\prod_{k=0,k \neq j}^n x_k", "(prod ((k = 0) (k ≠ j)) n (_ x k))"),
        (r"\sum_i \sum_j a_i b_j", "(sum (i) _ (sum (j) _ (* (_ a i) (_ b j))))"),
        (r"b \sum_i a_i", "(* b (sum (i) _ (_ a i)))"),
        (r"\sum_i -x_i", "(sum (i) _ (+ (- (_ x i))))"),
        (r"\max_{x \neq 0} \frac{1}{x}", "(max ((x ≠ 0)) _ (frac 1 x))"),
        (r"\min(a, b)", "(min: a b)"),
        (r"\max\{a, b\}", "(max: (set a b))"),
        (r"\min \sum_i x_i", "(min () _ (sum (i) _ (_ x i)))"),
        (r"\lim_{k\to\infty} S_k", "(lim ((k → infty)) _ (_ S k))"),
        (r"\bigcup_i A_i", "(union (i) _ (_ A i))"),
    ]);
}

#[test]
fn matrices_and_cases() {
    check(&[
        (r"\begin{pmatrix} 1 & 2 \\ 3 & 4 \end{pmatrix}", "(pmatrix 1 2 / 3 4)"),
        (r"\begin{matrix} a \end{matrix}", "(matrix a)"),
        (r"\begin{bmatrix} a & -b \\ \end{bmatrix}", "(bmatrix a (+ (- b)))"),
        (r"\begin{vmatrix} a & b \\ c & d \end{vmatrix}", "(vmatrix a b / c d)"),
        (r"\left(\begin{smallmatrix} a \\ b \end{smallmatrix}\right)", "(pmatrix a / b)"),
        (r"\left[\begin{matrix} a & b \end{matrix}\right]", "(bmatrix a b)"),
        (r"\left|\begin{matrix} a \end{matrix}\right|", "(vmatrix a)"),
        (
            r"\left( \begin{array} { c c } { a } & { } \\ { c } & { d } \end{array} \right)",
            "(pmatrix a _ / c d)",
        ),
        (r"\begin{pmatrix} a & b \\ c \\ & \ddots \end{pmatrix}", "(pmatrix a b / c / _ …)"),
        (r"\begin{pmatrix} n \\ i \end{pmatrix}", "(pmatrix n / i)"),
        (r"\pmatrix{a & b \cr c & d}", "(pmatrix a b / c d)"),
        (r"\begin{pmatrix} 1 \\[2pt] 2 \end{pmatrix}^{-1}", "(^ (pmatrix 1 / 2) (+ (- 1)))"),
        (r"\begin{cases} 1, & i = 0 \\ 0, & i \neq 0 \end{cases}", "(cases 1 if (i = 0) / 0 if (i ≠ 0))"),
        (
            r"\begin{cases} 1 & \text{if } i = 0 \\ 0 & \text{otherwise} \end{cases}",
            "(cases 1 if (i = 0) / 0 if _)",
        ),
        (r"\begin{cases} 1,\ if \ i \le t \\ 0,\ otherwise \end{cases}", "(cases 1 if (i ≤ t) / 0 if _)"),
        (r"\cases{1 & i=0 \cr 0 & i>0}", "(cases 1 if (i = 0) / 0 if (i > 0))"),
        (
            r"\left\{ \begin{array}{ll} t & t \ge 0 \\ -t & t < 0 \end{array} \right.",
            "(cases t if (t ≥ 0) / (+ (- t)) if (t < 0))",
        ),
        (r"\begin{cases} x = x(t) \\ y = y(t) \end{cases}", "(seq (x = (x: t)) (y = (y: t)))"),
        (r"\left\{\begin{aligned} x &= 1 \\ y &= 2 \end{aligned}\right.", "(seq (x = 1) (y = 2))"),
        (r"\begin{cases} a, b = 1 \\ c, & d = 2 \end{cases}", "(cases a if (b = 1) / c if (d = 2))"),
    ]);
}

#[test]
fn relations() {
    check(&[
        ("a = b < c", "(a = b < c)"),
        (r"a \equiv b \neq c \ne d", "(a ≡ b ≠ c ≠ d)"),
        (r"a \le b \leq c \leqslant d", "(a ≤ b ≤ c ≤ d)"),
        (r"a \ge b \geq c \geqslant d \gt e", "(a ≥ b ≥ c ≥ d > e)"),
        (r"a \approx b", "(a ≈ b)"),
        (r"x \in \mathbb{R}", "(x ∈ (bb R))"),
        (r"A \subseteq B \subset C", "(A ⊆ B ⊆ C)"),
        (r"a := b", "(a := b)"),
        (r"a \triangleq b", "(a := b)"),
        (r"a \coloneqq b", "(a := b)"),
        (r"a \stackrel{\text{def}}{=} b", "(a := b)"),
        (r"a \overset{\Delta}= b", "(a := b)"),
        (r"a \stackrel{!}{=} b", "(a = b)"),
        (r"a \not= b", "(a ≠ b)"),
        (r"a \to b \rightarrow c", "(a → b → c)"),
        (r"a \xrightarrow{n} b", "(a → b)"),
        (r"t \mapsto t^2", "(t ↦ (^ t 2))"),
        (r"a = b \Rightarrow c = d", "((a = b) ⇒ (c = d))"),
        (r"a = b \iff c = d", "((a = b) ⇔ (c = d))"),
        (r"F:\mathbb{R}\to\mathbb{R}", "(F : (bb R) → (bb R))"),
        (r"\forall t : f(t) = t", "(all (t) ((f: t) = t))"),
        (r"\forall t_1,\dots,t_k, f(t_1) = 0", "(all ((_ t 1) … (_ t k)) ((f: (_ t 1)) = 0))"),
        (r"\forall x \in P, \forall a, x = a", "(all ((x ∈ P)) (all (a) (x = a)))"),
        (r"||x|| \ge 0, \forall x \in X", "(seq ((norm x) ≥ 0) (all ((x ∈ X)) _))"),
    ]);
}

#[test]
fn sequences() {
    check(&[
        ("a = b, c = d", "(seq (a = b) (c = d))"),
        (r"a = b \quad c = d", "(seq (a = b) (c = d))"),
        (r"a = b,\qquad c = d.", "(seq (a = b) (c = d))"),
        (r"a = b \quad = c", "(a = b = c)"),
        (r"a = b \ \ t \in [0,1]", "(seq (a = b) (t ∈ (list 0 1)))"),
        (r"a = b \text{ with } c = d", "(seq (a = b) \"with\" (c = d))"),
        (r"t^3 \text{ by } \sigma", "(seq (^ t 3) \"by\" sigma)"),
        ("f(1) = b for i = 0", "(seq ((f: 1) = b) \"for\" (i = 0))"),
        ("a if t = 0, b otherwise", "(seq a \"if\" (t = 0) b \"otherwise\")"),
        ("if(t)", "(* i (f: t))"),
        ("i = 1, 2, ..., n", "(seq (i = 1) 2 … n)"),
        ("F = t^2 其中 t = 1", "(seq (F = (^ t 2)) \"其中\" (t = 1))"),
        (r"a \\ b", "(seq a b)"),
        (r"a \\ = b", "(a = b)"),
        (r"a = b \\ + c", "(a = (+ b c))"),
        (r"\begin{aligned} a &= b \\ &= c \\ d &= e \end{aligned}", "(seq (a = b = c) (d = e))"),
        (r"\begin{align*} a &= b & c &= d \end{align*}", "(seq (a = b) (c = d))"),
        (r"\begin{array}{rcl} a & = & b \\ & = & c \end{array}", "(a = b = c)"),
        (r"\begin{array}{ll} F: A \to B & F(u) \end{array}", "(seq (F : A → B) (F: u))"),
        (r"\begin{gather} a = b \\ c = d \end{gather}", "(seq (a = b) (c = d))"),
        (r"\frac{1}{6} [a \\ + b] \\ = c", "((* (frac 1 6) [(+ a b)]) = c)"),
        (r"\left( a \right. \\ \left. + b \right)", "[(+ a b)]"),
        (r"B=\{&\\ &1,\\ &u\\ &v \\ \}", "(B = (set 1 u v))"),
    ]);
}

#[test]
fn layout_is_ignored() {
    check(&[
        ("$t$", "t"),
        ("$$ t $$", "t"),
        (r"\( t \)", "t"),
        (r"\[ t \]", "t"),
        (r"a \, b \; c \: d \! e~f", "(* a b c d e f)"),
        (r"\displaystyle {a}{b} {}", "(* a b)"),
        (r"a = b \label{x} \tag{1}", "(a = b)"),
        (r"a = b \nonumber \\", "(a = b)"),
        ("a % comment\n + b", "(+ a b)"),
        (r"\boxed{a = b}", "(a = b)"),
        (r"\textcolor{red}{a} + \color{blue} b", "(+ a b)"),
        (r"{ { a } } _ { 1 }", "(_ a 1)"),
        ("a &= b", "(a = b)"),
        (r"a = b,\\", "(a = b)"),
    ]);
}

#[test]
fn signs_below() {
    check(&[
        (r"x \in \mathbb{R}_+", "(x ∈ (_ (bb R) plus))"),
        (r"\mathbb{H}_{-}", "(_ (bb H) minus)"),
        (r"\text{err}_{i+1}", "(_ err (+ i 1))"),
        (r"\tilde{x^{(+)}} + x_i^{(-)}", "(+ (tilde (upper x plus)) (upper (_ x i) minus))"),
        (r"c =: d", "(c = d)"),
        (r"\text{size} = n - \text{shift}", "(size = (+ n (- shift)))"),
    ]);
}

#[test]
fn arrows_and_signs_before_formulas_are_words() {
    for text in [r"\therefore a = b", r"\because a = b", r"\Rightarrow a = b", r"⇒ a = b"] {
        let read = sexpr(&read(text).unwrap());
        assert!(read.contains("(a = b)"), "{text}: {read}");
    }
}

#[test]
fn cases_with_nothing_in_the_first_column() {
    let columns = r"\begin{cases} &1\quad (0\le t< 1)\\ &0\quad (\text{otherwise}) \end{cases}";
    let usual = r"\begin{cases} 1 & (0\le t< 1)\\ 0 & (\text{otherwise}) \end{cases}";
    assert_eq!(sexpr(&read(columns).unwrap()), sexpr(&read(usual).unwrap()));
}

#[test]
fn exponents_in_brackets() {
    check(&[
        ("(1-t)^{(n-i)}", "(^ [(+ 1 (- t))] [(+ n (- i))])"),
        ("(1-t)⁽ⁿ⁻ⁱ⁾", "(^ [(+ 1 (- t))] [(+ n (- i))])"),
        ("t^i(1-t)^{(n-i)}", "(^ ((^ t i): (+ 1 (- t))) [(+ n (- i))])"),
        ("(x+1)^{(k)}", "(upper [(+ x 1)] k)"),
        ("(f+g)^{(n-1)}", "(upper [(+ f g)] (+ n (- 1)))"),
        ("(uv)^{(n-1)}", "(upper [(* u v)] (+ n (- 1)))"),
        ("t^{(n-1)}", "(upper t (+ n (- 1)))"),
    ]);
}

#[test]
fn signs_of_which_nothing_is_known() {
    check(&[
        (r"a \sim b = c", "(a ∼ b = c)"),
        ("x ≲ y", "(x ≲ y)"),
        (r"x \not\in S", "(x ∉ S)"),
        (r"a + b \pm 2c - d", "(+ (pm: (+ a b) (* 2 c)) (- d))"),
        (r"\frac{-b \pm \sqrt{d}}{2}", "(frac (pm: (+ (- b)) (sqrt: d)) 2)"),
        (r"x = \pm 1", "(x = (pm: 1))"),
        (r"7 \equiv 1 \pmod 3", "(7 ≡ (pmod: 1 3))"),
        (r"7 \equiv 1 \mod 3", "(7 ≡ (pmod: 1 3))"),
        (r"f(x) = x (\bmod 3)", "((f: x) ≡ (pmod: x 3))"),
        (r"7 \bmod 3 = 1", "((mod: 7 3) = 1)"),
        (r"[a; b, c]", "(semicolons: a ; b c)"),
        ("p(x|z)", "(p: (x ∣ z))"),
        ("D(p||q)", "(D: (p ∥ q))"),
        ("f(|x|)", "(f: (abs x))"),
        (r"\oint_\gamma f \,dz", "(int gamma _ f z)"),
        (r"\iint_D x \,dx\,dy", "(int D _ x (tuple x y))"),
        (r"\oint_\gamma f = 0", "((int gamma _ f (seq )) = 0)"),
        (r"\int_0^1 t \,\text{d}t", "(int 0 1 t t)"),
        (r"\underset{x}{\max} f(x)", "(max (x) _ (f: x))"),
        (r"\underset{x}{\textrm{argmin}} (f)", "((_ argmin x): f)"),
        (r"2 + 1 = 3 \; \checkmark", "((+ 2 1) = 3)"),
    ]);
}

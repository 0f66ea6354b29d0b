//! Equations that look like identities and must not be proved.

use super::{brute, proof, sides};

const WRONG: &[&str] = &[
    // recurrence
    r"B_i^n(t) = (1-t)B_i^{n-1}(t) + tB_{i+1}^{n-1}(t)",
    r"B_i^n(t) = tB_i^{n-1}(t) + (1-t)B_{i-1}^{n-1}(t)",
    r"B_i^n(t) = (1-t)B_i^{n-1}(t) - tB_{i-1}^{n-1}(t)",
    r"B_i^n(t) = (1-t)B_i^{n}(t) + tB_{i-1}^{n}(t)",
    r"B_i^n(t) = B_{n-i}^n(t)",
    r"B_i^n(t) = B_{n-i+1}^n(1-t)",
    r"B_i^n(t) = \binom{n}{i} t^i (1-t)^{n+i}",
    r"B_i^n(t) = C_{n-i}^n(1-t)^{n-i}t^i",
    // derivatives
    r"\frac{d}{dt}B_i^n(t) = n\left[B_i^{n-1}(t) - B_{i-1}^{n-1}(t)\right]",
    r"\frac{d}{dt}B_i^n(t) = (n-1)\left[B_{i-1}^{n-1}(t) - B_i^{n-1}(t)\right]",
    r"\frac{d}{dt}B_i^n(t) = n\left[B_{i-1}^{n-1}(t) + B_i^{n-1}(t)\right]",
    r"\frac{d^2}{dt^2}B_i^n(t) = n(n-1)\left[B_{i-1}^{n-2}(t) - 2B_{i-1}^{n-2}(t) + B_i^{n-2}(t)\right]",
    r"\frac{d^2}{dt^2}B_i^n(t) = n(n-1)\left[B_{i-2}^{n-2}(t) - B_{i-1}^{n-2}(t) + B_i^{n-2}(t)\right]",
    r"\frac{d^2}{dt^2}B_i^n(t) = n^2\left[B_{i-2}^{n-2}(t) - 2B_{i-1}^{n-2}(t) + B_i^{n-2}(t)\right]",
    r"\left.\frac{d}{dt}B_i^n(t)\right|_{t=0} = \begin{cases} -n, & i = 0 \\ n, & i = n \\ 0, & i > 1 \end{cases}",
    // elevation
    r"B_i^n(t) = \left(1 - \frac{i}{n+1}\right)B_i^{n+1}(t) + \frac{i+1}{n+1}B_{i-1}^{n+1}(t)",
    r"B_i^n(t) = \left(1 - \frac{i}{n}\right)B_i^{n+1}(t) + \frac{i+1}{n+1}B_{i+1}^{n+1}(t)",
    r"B_i^n(t) = \left(1 - \frac{i}{n+1}\right)B_i^{n+1}(t) + \frac{i}{n+1}B_{i+1}^{n+1}(t)",
    r"t B_i^n = \frac{i}{n+1}B_{i+1}^{n+1}",
    r"(1-t) B_i^n(t) = \frac{n-i}{n+1}B_{i}^{n+1}(t)",
    // binomials
    r"\binom{n}{k} = \binom{n-1}{k} + \binom{n-1}{k+1}",
    r"\binom{n+1}{k} = \binom{n}{k} + \binom{n}{k+1}",
    r"k\binom{n}{k} = k\binom{n-1}{k-1}",
    r"\binom{n}{k} = \frac{n!}{k!(n-k+1)!}",
    r"\binom{n}{k} = \frac{n!}{(n-k)!}",
    r"\binom{n}{j}\binom{j}{i} = \binom{n}{i}\binom{n-i}{j}",
    r"B_i^m(t) B_j^n(t) = \frac{\binom{m}{i}\binom{n}{j}}{\binom{m+n}{i}} B_{i+j}^{m+n}(t)",
    r"B_i^m(t) B_j^n(t) = B_{i+j}^{m+n}(t)",
    // integrals and values
    r"\int_0^1 B_i^n(t)\,dt = \frac{1}{n}",
    r"\int_0^1 B_i^n(t)\,dt = \frac{i+1}{n+1}",
    r"\int_0^1 \frac{d}{dt} t^k\,dt = 1",
    r"B_i^n(0) = \begin{cases} 1, & i = 1 \\ 0, & i \neq 1 \end{cases}",
    r"B_i^n(1) = \begin{cases} 1, & i = 0 \\ 0, & i \neq 0 \end{cases}",
    r"B_i^n(0) = 0",
    // families
    r"\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n-1}(b_{i+1}-b_i)B_i^{n-1}(t)",
    r"\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t) = n\sum_{i=0}^{n}(b_{i+1}-b_i)B_i^{n}(t)",
    r"\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t) = n\sum_{i=0}^{n-2}(b_{i+1}-b_i)B_i^{n-1}(t)",
    r"\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t) = n\sum_{i=0}^{n-1}(b_{i}-b_{i-1})B_i^{n-1}(t)",
    r"\frac{d^2}{dt^2}\sum_{i=0}^n b_i B_i^n(t) = n(n-1)\sum_{i=0}^{n-2}(b_{i+2} - b_{i+1} + b_i) B_i^{n-2}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n-1}(t b_i + (1-t) b_{i+1}) B_i^{n-1}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n}\left(\frac{i}{n+1}b_{i-1} + \left(1-\frac{i}{n+1}\right)b_i\right) B_i^{n+1}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = b_0 (1-t)^n + \sum_{i=1}^{n-1} b_i B_i^n(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = b_0 (1-t)^n + \sum_{i=0}^n b_i B_i^n(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^n b_{n-i} B_i^n(t)",
    r"\Delta^k b_i = \Delta^{k-1} b_{i+1} + \Delta^{k-1} b_i",
    r"\Delta^k b_i = \sum_{j=0}^k (-1)^{j}\binom{k}{j} b_{i+j}",
    r"\left.\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t)\right|_{t=0} = n(b_0 - b_1)",
    // sums
    r"\sum_{i=0}^{n-1} B_i^n(t) = 1",
    r"\sum_{i=1}^n B_i^n(t) = 1",
    r"\sum_{i=0}^n \frac{i}{n} B_i^n(t) = 1 - t",
    r"\sum_{i=0}^n i B_i^n(t) = t",
    r"\sum_{i=0}^n i^2 B_i^n(t) = n(n-1)t^2",
    r"t^{j} = \sum_{i=j}^{n} \frac{C_{n-j}^{i-j}}{C_{n}^{j}} B_{i}^{n}(t)",
    r"t^{j} = \sum_{i=j}^{n} \frac{C_{n}^{i-j}}{C_{n}^{i}} B_{i}^{n}(t)",
    r"\sum_{i=0}^n \binom{n}{i} = 2^{n-1}",
    r"\sum_{i=0}^n (-1)^i\binom{n}{i} = 0",
    r"\sum_{i=1}^{n-1} \binom{n}{i} = 2^n - 2",
    r"\sum_{i=1}^{n} \frac{1}{n} = 1",
    r"\sum_{i=0}^n \binom{n}{i} x^i y^{n-i} = (x-y)^n",
    r"\sum_{j=0}^k \binom{m}{j}\binom{n}{k-j} = \binom{m+n}{k+1}",
    r"\sum_{i=0}^n \binom{n}{i}^2 = \binom{2n}{n+1}",
    r"\sum_{i=0}^n i = \frac{n(n-1)}{2}",
    r"\sum_{i=0}^{n} x^i = \frac{1-x^{n}}{1-x}",
    r"\sum_{i=0}^{n-2} 2^i = 2^{n-1} - 1",
    r"\sum_{i=0}^n B_i^n(t) s^i = (1 - t + s)^n",
    r"B_i^n(t) = \sum_{j=i}^n (-1)^{j-i}\binom{n}{j}\binom{i}{j} t^j",
    r"B_i^n(ct) = \sum_{j=i}^n B_j^i(c) B_j^n(t)",
    r"\sum_{i=k}^n \binom{i}{k} = \binom{n}{k+1}",
    r"\sum_{i=k}^n \binom{i}{k} = \binom{n+1}{k}",
    r"\sum_{i=0}^n \binom{m+i}{i} = \binom{m+n}{n}",
    r"\sum_{i=0}^n i\, i! = (n+1)!",
    r"\sum_{i=1}^n \frac{1}{i(i+1)} = \frac{n+1}{n+2}",
    r"\sum_{i=0}^n \frac{1}{i+1} = \sum_{j=1}^{n} \frac{1}{j}",
    r"\sum_{i=0}^n \binom{n}{i}^3 t^i = \sum_{j=1}^n \binom{n}{j}^3 t^{n-j}",
    r"\sum_{i=0}^n i(i-1)\cdots(i-k+1) B_i^n(t) = n(n-1)\cdots(n-k) t^k",
    r"\sum_{i=0}^n i(i-1)\cdots(i-k+1) B_i^n(t) = n(n-1)\cdots(n-k+1) t^{k+1}",
    r"\sum_{i=0}^n \binom{i}{k} \binom{n-i}{j} = \binom{n+1}{j+k}",
    r"\sum_{i=0}^{n-1} \binom{i}{k} \binom{n-i}{j} = \binom{n+1}{j+k+1}",
    // derivatives of any order, integrals with a variable end
    r"\int_0^t B_i^n(x) dx = \frac{1}{n+1}\sum_{j=i}^{n+1} B_j^{n+1}(t)",
    r"\int_0^t B_i^n(x) dx = \frac{1}{n}\sum_{j=i+1}^{n+1} B_j^{n+1}(t)",
    r"\int_0^t x^n dx = \frac{t^{n+1} + 1}{n+1}",
    r"\frac{d}{dt}\sum_{i=k}^n B_i^n(t) = n B_{k}^{n-1}(t)",
    r"\sum_{i=0}^k (-1)^i \binom{n}{i} = (-1)^k \binom{n}{k}",
    r"\sum_{i=k}^{n} x^i = \frac{x^k - x^{n}}{1-x}",
    r"\frac{d^k}{dt^k}B_i^n(t) = \frac{n!}{(n-k)!}\sum_{j=0}^k (-1)^{k-j}\binom{k}{j} B_{i-k+j}^{n-k}(t)",
    r"\frac{d^k}{dt^k}\sum_{i=0}^n b_i B_i^n(t) = \frac{n!}{k!}\sum_{i=0}^{n-k} \Delta^k b_i B_i^{n-k}(t)",
    r"\frac{d^k}{dt^k}\sum_{i=0}^n b_i B_i^n(t) = \frac{n!}{(n-k)!}\sum_{i=1}^{n-k} \Delta^k b_i B_i^{n-k}(t)",
    r"\frac{d^k}{dt^k}t^n = \frac{n!}{(n-k+1)!}t^{n-k}",
    // elementary symmetric functions
    r"\sigma_{i,n}(t_1,\dots,t_n) = \frac{(n-i)\sigma_{i,n-1}(t_1,\dots,t_{n-1}) + i t_n \sigma_{i,n-1}(t_1,\dots,t_{n-1})}{n}",
    r"\sigma_{i,n}(t_1,\dots,t_n) = \frac{i\sigma_{i,n-1}(t_1,\dots,t_{n-1}) + (n-i) t_n \sigma_{i-1,n-1}(t_1,\dots,t_{n-1})}{n}",
    r"e_i(t_1,\dots,t_n) = e_i(t_1,\dots,t_{n-1}) + t_n e_{i}(t_1,\dots,t_{n-1})",
    r"e_i(t_1,\dots,t_n) = e_i(t_1,\dots,t_{n-1}) + t_{n-1} e_{i-1}(t_1,\dots,t_{n-1})",
];

/// Nothing here may be proved; that the evaluator finds a counterexample shows that each is wrong.
#[test]
fn near_misses() {
    for text in WRONG {
        let (left, right) = sides(text);
        let (witness, tried) = brute::refutation(&left, &right, 4, true);
        assert!(witness.is_some(), "{text} seems to be right ({tried} values)");
        assert!(proof(text).is_none(), "proved: {text}");
    }
}

/// What makes no sense, or cannot be told from something else, is not proved either.
#[test]
fn nonsense() {
    for text in [
        r"\binom{-1}{2} = 5",
        r"\frac{1}{\binom{3}{5}} = 7",
        r"(-1)! = 3",
        r"\int_0^1 \frac{t^n-1}{t-1} dt = 0",
        r"\int_0^1 \frac{1}{t} dt = 0",
        r"f(t+1) = f(t) + f",
        r"f(t+1) = f t + f",
        r"\sin(2x) = 2 \sin x",
        r"\frac{d}{dt} x = 0",
        r"\frac{d}{dt} F = 0",
        r"b_1^2 = b_1 b_1",
        r"\frac{d}{dt} b_i^k = 0",
        r"n^0 = 1 + 0^n",
        r"\frac{0}{0} = 1",
        r"n^i n^j = n^{i+j+1}",
        r"\sum_i b_i = \sum_j c_j",
        r"\frac{d}{dt} (t b_i(t)) = b_i(t)",
        r"\left.(1+u) f(u)\right|_{u=0} = f(u)",
        r"\int_0^1 t f(t) dt = \frac{1}{2} f(t)",
        r"\sum_{i=0}^n f(i) = (n+1) f(i)",
        r"f(u, v) = f(v, u)",
        r"f(2t) = 2 f(t)",
        r"b_i(t) = b_i",
        r"b_i^2(t) = b_i(t) b_i(t)",
        r"b_i^k(t + 1) = b_i^k t + b_i^k + 0 b_i",
        r"A B = B A",
        r"A_n A_m = A_m A_n",
        r"(A B)^n = A^n B^n",
        r"\mathbf{a}(\mathbf{b}\mathbf{c}) = (\mathbf{a}\mathbf{b})\mathbf{c}",
        r"\begin{cases} \frac{(i-1)!}{(i-1)!}, & i \neq 0 \\ 5, & i = 0 \end{cases} = 1",
        r"x(u+v) = x(u) + x v",
        r"n(n-1)\cdots(n-k) = \frac{n!}{(n-k)!}",
        r"\sigma_{i,n}(t,\dots,t) = t^n",
        r"B_i^n(\underbrace{t,\dots,t}_n) = t^i",
        r"\left.\frac{1 - t^n}{(1-t)^k}\right|_{t=1} = 0",
    ] {
        assert!(proof(text).is_none(), "proved: {text}");
    }
}

//! Families that must be proved.

use super::{brute, proof, sides};

const TERMS: &[&str] = &[
    r"B_i^n(t) = (1-t)B_i^{n-1}(t) + tB_{i-1}^{n-1}(t)",
    r"B_i^n(t) = B_{n-i}^n(1-t)",
    r"B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}",
    r"B_i^n(t) = C_n^i t^i(1-t)^{n-i}",
    r"\frac{d}{dt}B_i^n(t) = n\left[B_{i-1}^{n-1}(t) - B_i^{n-1}(t)\right]",
    r"\frac{dB_i^n(t)}{dt} = n(B_{i-1}^{n-1}(t) - B_i^{n-1}(t))",
    r"(B_i^n)'(t) = n(B_{i-1}^{n-1}(t) - B_i^{n-1}(t))",
    r"\dot B_i^n(t) = n(B_{i-1}^{n-1}(t) - B_i^{n-1}(t))",
    r"\frac{d^2}{dt^2}B_i^n(t) = n(n-1)\left[B_{i-2}^{n-2}(t) - 2B_{i-1}^{n-2}(t) + B_i^{n-2}(t)\right]",
    r"B_i^n(t) = \left(1 - \frac{i}{n+1}\right)B_i^{n+1}(t) + \frac{i+1}{n+1}B_{i+1}^{n+1}(t)",
    r"t B_i^n = \frac{i+1}{n+1}B_{i+1}^{n+1}",
    r"(1-t) B_i^n(t) = \frac{n+1-i}{n+1}B_{i}^{n+1}(t)",
    r"\binom{n}{k} = \binom{n-1}{k} + \binom{n-1}{k-1}",
    r"k\binom{n}{k} = n\binom{n-1}{k-1}",
    r"\binom{n}{k} = \frac{n}{k}\binom{n-1}{k-1}",
    r"\binom{n}{k} = \frac{n!}{k!(n-k)!}",
    r"\binom{n}{k} = \binom{n}{n-k}",
    r"\binom{n}{j}\binom{j}{i} = \binom{n}{i}\binom{n-i}{j-i}",
    r"B_i^m(t) B_j^n(t) = \frac{\binom{m}{i}\binom{n}{j}}{\binom{m+n}{i+j}} B_{i+j}^{m+n}(t)",
    r"\int_0^1 B_i^n(t)\,dt = \frac{1}{n+1}",
    r"\int_0^1 t B_i^n(t)\,dt = \frac{i+1}{(n+1)(n+2)}",
    r"B_{i,j,k}^n(u,v,w) = uB_{i-1,j,k}^{n-1}(u,v,w) + vB_{i,j-1,k}^{n-1}(u,v,w) + wB_{i,j,k-1}^{n-1}(u,v,w)",
    r"B_i^n(0) = \begin{cases} 1, & i = 0 \\ 0, & i \neq 0 \end{cases}",
    r"B_i^n(1) = \begin{cases} 1, & i = n \\ 0, & i \neq n \end{cases}",
    r"t^n t = t^{n+1}",
    r"(n+1)! = (n+1) n!",
    r"(xy)^n = x^n y^n",
    r"4^n = 2^n 2^n",
    r"(-1)^{n-i} = (-1)^{n+i}",
    r"B_0^n(t) = (1-t)^n",
    r"B_n^n(t) = t^n",
    r"B_0^n(0) = 1",
    r"B_n^n(1) = 1",
    r"\left.\frac{d}{dt}B_i^n(t)\right|_{t=0} = \begin{cases} -n, & i = 0 \\ n, & i = 1 \\ 0, & i > 1 \end{cases}",
    r"\frac{d}{dt} t^n = n t^{n-1}",
    r"\sigma_{i,n}(t_1,\dots,t_n) = \frac{(n-i)\sigma_{i,n-1}(t_1,\dots,t_{n-1}) + i t_n \sigma_{i-1,n-1}(t_1,\dots,t_{n-1})}{n}",
    r"e_i(t_1,\dots,t_n) = e_i(t_1,\dots,t_{n-1}) + t_n e_{i-1}(t_1,\dots,t_{n-1})",
    r"\prod_{j=0}^{k-1}(n-j) = \frac{n!}{(n-k)!}",
    r"B_i^{(n)}(t) = (1-t)B_i^{(n-1)}(t) + tB_{i-1}^{(n-1)}(t)",
    r"\frac{n!}{(n-k)!} = n(n-1)\cdots(n-k+1)",
    r"\binom{n}{k} = \frac{n(n-1)\cdots(n-k+1)}{k!}",
    r"n! = 1\cdot 2\cdots n",
    r"\sigma_{i,n}(t,\dots,t) = t^i",
    r"B_i^n\left(\frac{t-a}{b-a}\right) = \binom{n}{i}\frac{(t-a)^i(b-t)^{n-i}}{(b-a)^n}",
];

/// Functions that nobody defines; the evaluator does not know them.
const OPAQUE: &[&str] = &[
    r"\sum_{i=1}^n\sum_{j=1}^n b_i(u) b_j(v) p_{i,j} = \sum_{j=1}^n b_j(v)\sum_{i=1}^n b_i(u) p_{i,j}",
    r"(1-t) f(u, v) + t f(u, v) = f(u, v)",
    r"\sum_{i=0}^{n} b_i(t) - \sum_{i=1}^{n} b_i(t) = b_0(t)",
    r"\sum_{i=0}^{n-1} (b_{i+1}^k(t) - b_i^k(t)) = b_n^k(t) - b_0^k(t)",
];

const MORE: &[&str] = &[
    r"\frac{d}{dt}\sum_{i=k}^n B_i^n(t) = n B_{k-1}^{n-1}(t)",
    r"\sum_{i=0}^k (-1)^i \binom{n}{i} = (-1)^k \binom{n-1}{k}",
    r"\sum_{i=0}^n \left(\frac{i}{n} - t\right)^2 B_i^n(t) = \frac{t(1-t)}{n}",
    r"\int_0^1 B_i^n(t) B_j^m(t) dt = \frac{\binom{n}{i}\binom{m}{j}}{(n+m+1)\binom{n+m}{i+j}}",
    r"\sum_{i=0}^n i(i-1)\cdots(i-k+1) B_i^n(t) = n(n-1)\cdots(n-k+1) t^k",
    r"\sum_{i=k}^n i(i-1)\cdots(i-k+1) B_i^n(t) = n(n-1)\cdots(n-k+1) t^k",
    r"B_i^n(t) = \frac{n-i+1}{i}\frac{t}{1-t} B_{i-1}^n(t)",
    r"\sum_{i=k}^{n} x^i = \frac{x^k - x^{n+1}}{1-x}",
];

const VANDERMONDE: &[&str] = &[
    r"\sum_{i=0}^n \binom{i}{k} \binom{n-i}{j} = \binom{n+1}{j+k+1}",
    r"\sum_{i=0}^n i \binom{i}{k} = (k+1)\binom{n+1}{k+2} + k\binom{n+1}{k+1}",
    r"\sum_{i=0}^n i\binom{n}{i}^2 = n\binom{2n-1}{n-1}",
    r"\sum_{i=0}^n \binom{m}{i}\binom{n}{i} = \binom{m+n}{n}",
];

const FAMILIES: &[&str] = &[
    r"\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t) = n\sum_{i=0}^{n-1}(b_{i+1}-b_i)B_i^{n-1}(t)",
    r"\frac{d}{dt}\sum_{i=0}^n \mathbf{b}_i B_i^n(t) = n\sum_{i=0}^{n-1}\Delta\mathbf{b}_iB_i^{n-1}(t)",
    r"\frac{d^2}{dt^2}\sum_{i=0}^n b_i B_i^n(t) = n(n-1)\sum_{i=0}^{n-2}\Delta^2 b_i B_i^{n-2}(t)",
    r"\frac{d^2}{dt^2}\sum_{i=0}^n b_i B_i^n(t) = n(n-1)\sum_{i=0}^{n-2}(b_{i+2} - 2b_{i+1} + b_i) B_i^{n-2}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n-1}((1-t)b_i + t b_{i+1}) B_i^{n-1}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n+1}\left(\frac{i}{n+1}b_{i-1} + \left(1-\frac{i}{n+1}\right)b_i\right) B_i^{n+1}(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = b_0 (1-t)^n + \sum_{i=1}^n b_i B_i^n(t)",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^n b_{n-i} B_i^n(1-t)",
    r"\sum_{i=0}^n (a_i + b_i) B_i^n(t) = \sum_{i=0}^n a_i B_i^n(t) + \sum_{j=0}^n b_j B_j^n(t)",
    r"\sum_{i=0}^m\sum_{j=0}^n b_{i,j} B_i^m(u) B_j^n(v) = \sum_{j=0}^n\sum_{i=0}^m b_{ij} B_j^n(v) B_i^m(u)",
    r"\sum_{i=0}^m a_i B_i^m(t) \sum_{j=0}^n b_j B_j^n(t) = \sum_{k=0}^{m+n}\sum_{i=\max(0,k-n)}^{\min(m,k)} \frac{\binom{m}{i}\binom{n}{k-i}}{\binom{m+n}{k}} a_i b_{k-i} B_k^{m+n}(t)",
    r"\Delta^k b_i = \Delta^{k-1} b_{i+1} - \Delta^{k-1} b_i",
    r"\Delta^k b_i = \sum_{j=0}^k (-1)^{k-j}\binom{k}{j} b_{i+j}",
    r"\left.\frac{d}{dt}\sum_{i=0}^n b_i B_i^n(t)\right|_{t=0} = n(b_1 - b_0)",
];

fn all_proved(list: &[&str]) {
    let failed: Vec<&str> = list.iter().copied().filter(|text| proof(text).is_none()).collect();
    assert!(failed.is_empty(), "not proved:\n{}", failed.join("\n"));
}

#[test]
fn terms() {
    all_proved(TERMS);
}

#[test]
fn more() {
    all_proved(MORE);
    all_proved(VANDERMONDE);
    all_proved(OPAQUE);
}

#[test]
fn families() {
    all_proved(FAMILIES);
}

const SUMS: &[&str] = &[
    r"\sum_{i=0}^n B_i^n(t) = 1",
    r"1 = [t + (1 - t)]^n = \sum_{i=0}^n \binom{n}{i} t^i (1 - t)^{n-i}",
    r"\sum_{i=0}^n \frac{i}{n} B_i^n(t) = t",
    r"\sum_{i=0}^n i(i-1) B_i^n(t) = n(n-1) t^2",
    r"\sum_{i=0}^n i^2 B_i^n(t) = n t (1 + (n-1) t)",
    r"t^{j} = \sum_{i=j}^{n} \frac{C_{n-j}^{i-j}}{C_{n}^{i}} B_{i}^{n}(t)",
    r"\sum_{i=k}^n \frac{\binom{i}{k}}{\binom{n}{k}} B_i^n(t) = t^k",
    r"\sum_{i=0}^n \binom{n}{i} = 2^n",
    r"\sum_{i=0}^n \binom{n}{i} x^i y^{n-i} = (x+y)^n",
    r"\sum_{i=0}^n (-1)^i\binom{n}{i} x^i = (1-x)^n",
    r"\sum_{i=0}^n i\binom{n}{i} = n 2^{n-1}",
    r"\sum_{j=0}^k \binom{m}{j}\binom{n}{k-j} = \binom{m+n}{k}",
    r"\sum_{i=0}^n \binom{n}{i}^2 = \binom{2n}{n}",
    r"\sum_{i=0}^n \frac{(-1)^i}{i+1}\binom{n}{i} = \frac{1}{n+1}",
    r"\sum_{i=0}^n i = \frac{n(n+1)}{2}",
    r"\sum_{i=0}^n i^2 = \frac{n(n+1)(2n+1)}{6}",
    r"\sum_{i=0}^{n} x^i = \frac{1-x^{n+1}}{1-x}",
    r"\sum_{i=0}^{n-1} 2^i = 2^n - 1",
    r"\sum_{i+j+k=n} B_{i,j,k}^n(u,v,w) = (u+v+w)^n",
    r"\sum_{i+j=n} \frac{n!}{i!j!} x^i y^j = (x+y)^n",
    r"\sum_{i=1}^n \binom{n}{i} = 2^n - 1",
    r"\sum_{i=0}^n B_i^n(t) s^i = (1 - t + s t)^n",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{j=0}^n \binom{n}{j} \left(\sum_{i=0}^j (-1)^{j-i}\binom{j}{i} b_i\right) t^j",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{j=0}^n \binom{n}{j} \Delta^j b_0 t^j",
    r"B_i^n(t) = \sum_{j=i}^n (-1)^{j-i}\binom{n}{j}\binom{j}{i} t^j",
    r"B_i^n(ct) = \sum_{j=i}^n B_i^j(c) B_j^n(t)",
    r"\int_0^1 \sum_{i=0}^n b_i B_i^n(t) dt = \frac{1}{n+1} \sum_{i=0}^n b_i",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{i=0}^{n} b_i B_i^n(t) \sum_{j=0}^m B_j^m(s)",
    r"\sum_{i=0}^n\sum_{j=0}^m B_i^n(u) B_j^m(v) = 1",
    r"\frac{d}{dt}\sum_{i=0}^n B_i^n(t) = 0",
    r"\sum_{i=k}^n \binom{i}{k} = \binom{n+1}{k+1}",
    r"\sum_{i=0}^n \binom{m+i}{i} = \binom{m+n+1}{n}",
    r"\sum_{i=0}^n i\, i! = (n+1)! - 1",
    r"\sum_{i=1}^n \frac{1}{i(i+1)} = \frac{n}{n+1}",
    r"\sum_{i=0}^n \frac{1}{i+1} = \sum_{j=1}^{n+1} \frac{1}{j}",
    r"\sum_{i=0}^n \binom{n}{i}^3 t^i = \sum_{j=0}^n \binom{n}{j}^3 t^{n-j} t^{2j-n}",
    r"\sum_{i=0}^n \binom{n}{i}^3 t^i = \sum_{j=0}^n \binom{n}{j}^3 t^{n-j}",
    r"\sum_{i=0}^n b_i B_i^n(t) = \sum_{j=0}^{n+k} \left(\sum_{i=0}^n \frac{\binom{n}{i}\binom{k}{j-i}}{\binom{n+k}{j}} b_i\right) B_j^{n+k}(t)",
];

#[test]
fn sums() {
    all_proved(SUMS);
}

/// All lists of identities.
pub fn all() -> impl Iterator<Item = &'static str> {
    TERMS.iter().chain(MORE).chain(VANDERMONDE).chain(FAMILIES).chain(SUMS).chain(ORDERS).copied()
}

/// The identities really hold for small integers: a check of the evaluator and of these lists.
#[test]
fn they_hold() {
    for text in all() {
        let (left, right) = sides(text);
        let (witness, tried) = brute::refutation(&left, &right, 3, true);
        assert_eq!(witness, None, "{text}");
        assert!(tried > 0, "{text}");
    }
}

const ORDERS: &[&str] = &[
    r"\int_0^t B_i^n(x) dx = \frac{1}{n+1}\sum_{j=i+1}^{n+1} B_j^{n+1}(t)",
    r"\int_0^t x^n dx = \frac{t^{n+1}}{n+1}",
    r"\frac{d^k}{dt^k}\sum_{i=0}^n b_i B_i^n(t) = \frac{n!}{(n-k)!}\sum_{i=0}^{n-k} \Delta^k b_i B_i^{n-k}(t)",
    r"\frac{d^k}{dt^k}B_i^n(t) = \frac{n!}{(n-k)!}\sum_{j=0}^k (-1)^{j}\binom{k}{j} B_{i-k+j}^{n-k}(t)",
    r"\frac{d^k}{dt^k}t^n = \frac{n!}{(n-k)!}t^{n-k}",
];

#[test]
fn orders() {
    all_proved(ORDERS);
}

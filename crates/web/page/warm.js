// Browsers compile what runs, and better what runs often. So a page is checked in a worker of its own as soon as the first one is shown: who
// pastes notes does not wait for the compiler. What is compiled belongs to the module, in whatever worker it runs.

const WARM = String.raw`# Something of everything
The Bernstein polynomials $B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}$ have $\sum_{i=0}^n B_i^n(t) = 1$ and
$$\frac{d}{dt} B_i^n(t) = n \bigl(B_{i-1}^{n-1}(t) - B_i^{n-1}(t)\bigr), \qquad B_i^n(t) = (1-t) B_i^{n-1}(t) + t B_{i-1}^{n-1}(t).$$
Hence $\sum_{i=0}^n \frac{i}{n} B_i^n(t) = t$ and $\int_0^1 B_i^n(t)\,dt = \frac{1}{n+1}$.

Let $F(t) = t^3 - 3t^2 + 2$ with polar form $f(t_1, t_2, t_3) = t_1 t_2 t_3 - (t_1 t_2 + t_1 t_3 + t_2 t_3) + 2$. Then $f(0, 0, 1) = 2$, $F(2) = f(2, 2, 2) = 7$
and $F'(t) = 3 \bigl(f(1, t, t) - f(0, t, t)\bigr)$.

Let $b_i^0 = b_i$ and $b_i^r = (1-t) b_i^{r-1} + t b_{i+1}^{r-1}$; then $b_0^n = \sum_{i=0}^n b_i B_i^n(t)$.
Degree elevation: $\hat b_i = \frac{i}{n+1} b_{i-1} + \Bigl(1 - \frac{i}{n}\Bigr) b_i$.

$$N_i^k(t) = \frac{t - t_i}{t_{i+k} - t_i} N_i^{k-1}(t) + \frac{t_{i+k+1} - t}{t_{i+k+1} - t_{i+1}} N_{i+1}^{k-1}(t)$$

$$\begin{pmatrix} 1 & 2 \\ 0 & 1 \end{pmatrix}^2 = \begin{pmatrix} 1 & 4 \\ 0 & 1 \end{pmatrix}, \qquad \sum_{k=1}^n k^2 = \frac{n(n+1)(2n+1)}{6}, \qquad (a+b)^3 = a^3 + 3a^2 b + 3 a b^2 + b^2.$$

For $p(t) = (1-t)^2 p_0 + 2t(1-t) p_1 + t^2 p_2$ we have $p'(0) = 2 (p_1 - p_0)$, $p(1/2) = \frac{p_0 + 2 p_1 + p_2}{4}$ and $p''(t) = p_2 - 2 p_1 + p_0$.
`;

/** As long as it helps. */
async function warm() {
  const engine = new Engine();
  let best = Infinity;
  let first = null;
  for (let i = 0; i < 6; i++) {
    const begin = performance.now();
    const told = await engine.call({ do: "check", text: WARM }).catch(() => null);
    first ??= told;
    const time = performance.now() - begin;
    if (told === null || time > 0.9 * best) break;
    best = time;
  }
  engine.stop();
  // What sets the formulas is compiled in the same way.
  for (const one of first?.formulas ?? []) {
    formula(one.reading || one.latex, true, one.latex);
    await new Promise((next) => setTimeout(next, 5));
  }
}

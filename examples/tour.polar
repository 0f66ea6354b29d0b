# A script: one statement a line. Run it with: polarform run examples/tour.polar
F(t) := t^2 + 2t
G(t) := t^3 + 1
f := polar(F)
g := polar(G)

f(t, t) = F(t)                    # a claim: is it true?
f(g(0, 0, 1), g(1, 1, 1))
h := polar_compose(F, G)
h(t, t, t, t, t, t) = F(G(t))
h(0, 0, 0, 1, 1, 1)

"""Writes systems.json: linear systems with verdicts by exact rational arithmetic, each checked a second way.
  x(k+1) = F x(k) + G u(k) + v, cov(v) = V;   y(k) = H x(k) + w, cov(w) = W.       See README.md for every field."""
import json
from fractions import Fraction
import mpmath as mp
import sympy as sp

z, SYSTEMS, NAMES = sp.Symbol("z"), [], set()
# ---------------------------------------------------------------- building systems (entries are exact rationals)
def M(a): return sp.Matrix([[sp.Rational(*Fraction(v).as_integer_ratio()) if isinstance(v, float) else sp.Rational(v)
                             for v in row] for row in a])
def J(lam, n): return sp.Matrix(n, n, lambda i, j: M([[lam]])[0] if i == j else int(j == i + 1))   # Jordan block
def C(*c): return sp.Matrix(len(c), len(c), lambda i, j: int(j == i + 1) if i < len(c) - 1 else -M([[c[j]]])[0])  # z^n + c_{n-1} z^{n-1} + ... + c_0
def D(*blocks): return sp.diag(*[M([[b]]) if isinstance(b, (int, float)) else b for b in blocks])
def e(n, *idx): return sp.Matrix(len(idx), n, lambda i, j: int(j == idx[i]))         # rows that read single states
T = {1: M([[-1]]), 2: M([[2, 1], [1, 1]]), 3: M([[1, 2, 3], [0, 1, 4], [1, 2, 4]]),  # unimodular, to hide the structure
     4: M([[1, 1, 0, 2], [2, 3, 1, 4], [0, 1, 2, 1], [1, 1, 0, 3]])}
def pattern(n, i):  # G by turns: no input, last state, ones, two ends, zero, three columns
    return [sp.zeros(n, 0), e(n, n - 1).T, sp.ones(n, 1), e(n, 0, n - 1).T, sp.zeros(n, 1),
            sp.Matrix(n, 3, lambda r, c: (r + 1) ** c)][i % 6]
def add(name, F, H, V=1, W=1, G=None, hide=False, why=""):
    F, H = (a if isinstance(a, sp.MatrixBase) else M(a) for a in (F, H)); n, p = F.rows, H.rows
    V = M([[V]])[0] * sp.eye(n) if isinstance(V, (int, float)) else (V if isinstance(V, sp.MatrixBase) else M(V))
    W = M([[W]])[0] * sp.eye(p) if isinstance(W, (int, float)) else (W if isinstance(W, sp.MatrixBase) else M(W))
    G = pattern(n, len(SYSTEMS)) if G is None else M(G)
    if hide: t = T[n]; F, G, H, V, name = t * F * t.inv(), t * G, H * t.inv(), t * V * t.T, name + "-hidden-by-T"
    rows = lambda a: [[float(v) for v in a.row(i)] for i in range(a.rows)]
    s = dict(name=name, why=why, F=rows(F), G=rows(G), H=rows(H), V=rows(V), W=rows(W))
    for a, k in ((F, "F"), (G, "G"), (H, "H"), (V, "V"), (W, "W")):      # nothing may be lost on the way to binary64
        assert all(M([[v]])[0] == a[i, j] for i, r in enumerate(s[k]) for j, v in enumerate(r)), (name, k)
    assert name not in NAMES; NAMES.add(name); SYSTEMS.append((s, sp.ImmutableMatrix(F), G, H, V, W))
def both(name, *a, **k): add(name, *a, **k); add(name, *a, hide=True, **k)

def build():
    for f, h, v in ((1, 1, 1), (0, 1, 1), (2, 1, 1), (1, 0, 1), (1, 0, 0), (.5, 0, 1), (-1, 0, 0), (-1, 1, 0), (1, 1, 0), (2, 1, 0),
                    (2, 0, 0), (.5, 1, 0), (1, 1e-12, 1), (2, 1e-12, 0), (1 - 2**-30, 0, 1), (1 + 2**-30, 0, 1),
                    (1 - 2**-30, 1, 0), (1 + 2**-30, 1, 0), (1 - 2**-52, 0, 1)):
        add(f"scalar-F={f!r}-H={h}-V={v}", [[f]], [[h]], v, why="one state")
    for lam in (1, .5, 0):                                                                     # defective F
        for n in (2, 3, 4):
            add(f"jordan-{lam}-n{n}-first", J(lam, n), e(n, 0), hide=n == 3, why="the end of the chain is read: observable")
            add(f"jordan-{lam}-n{n}-last", J(lam, n), e(n, n - 1), hide=n > 2, why="the start of the chain is read: the rest is hidden")
    for lam in (2, -1): both(f"jordan-{lam}-n2-first", J(lam, 2), e(2, 0), 0, why="defective, no noise")
    why = "who reaches the mode on the circle?"
    add("chain1-no-noise", J(1, 2), e(2, 0), 0, why=why); add("chain1-noise-on-position", J(1, 2), e(2, 0), D(1, 0), why=why)
    add("chain1-noise-on-velocity", J(1, 2), e(2, 0), D(0, 1), why=why); add("chain1-n4-no-noise", J(1, 4), e(4, 0), 0, why=why)
    add("chain1-velocity-read-no-noise", J(1, 2), e(2, 1), 0, why="hidden position sums a velocity error that shrinks like 1/k: P grows without bound")
    circle = C(1, -1.5)                                                    # z^2 - 1.5 z + 1: on the circle, not a root of unity
    both("rotation-no-noise", circle, e(2, 0), 0, why=why); add("rotation-noise", circle, e(2, 1), why=why)
    add("rotation-unread-no-noise", circle, [[0, 0]], 0, why="P from I turns for ever: bounded, no limit")
    add("rotation-unread-noise", circle, [[0, 0]], why="noise piles up on an unread rotation")
    add("quarter-turn-unread-no-noise", [[0, -1], [1, 0]], [[0, 0]], 0, why="P = I stays for ever: a limit without detectability")
    add("quarter-turn-uneven-unread-no-noise", [[0, -2], [.5, 0]], [[0, 0]], 0, why="P has period 2 or 4: no limit")
    add("double-rotation-on-circle-no-noise", C(1, -3, 4.25, -3), e(4, 0), 0, why="(z^2-1.5z+1)^2: defective on the circle, unreached")
    add("sixth-turn-half-noise", C(1, -1), e(2, 0), D(0, 1), why="companion of z^2-z+1")
    add("float-rotation-0.6-0.8-unread", [[.6, -.8], [.8, .6]], [[0, 0]], 0, why="off the circle only by rounding of .6 and .8")
    add("plus-minus-one-unread-no-noise", D(1, -1), [[0, 0]], 0, why="P = I stays"); add("plus-minus-one-skew-unread-no-noise", [[1, 1], [0, -1]], [[0, 0]], 0, why="bounded, period 2")
    for v, tag in ((D(1, 0), "seen"), (D(0, 1), "hidden"), (0, "none"), (1, "both")):
        add(f"two-at-one-read-first-noise-{tag}", D(1, 1), e(2, 0), v, why="hidden mode at 1")
    add("two-at-one-read-sum-noise-first", D(1, 1), [[1, 1]], D(1, 0), why="hidden (1,-1), and the second state is a constant without noise")
    both("two-at-one-read-sum-noise-along-sum", D(1, 1), [[1, 1]], [[1, 1], [1, 1]], why="noise never reaches the hidden direction")
    add("plus-minus-one-hidden-beside-read", D(1, -1, .5), e(3, 2), D(0, 0, 1), hide=True, why="hidden modes at 1 and -1, tied to the read one by P = I")
    add("robot-landmark-relative", D(1, 1), [[-1, 1]], D(1, 0), W=.25, G=[[1], [0]], why="only the distance to a still landmark is read (SLAM on a line)")
    add("robot-3-landmarks-relative", sp.eye(4), [[-1, 1, 0, 0], [-1, 0, 1, 0], [-1, 0, 0, 1]], D(1, 0, 0, 0), G=[[1], [0], [0], [0]], why="the common shift is hidden")
    add("consensus-differences", [[.5, .25, 0, .25], [.25, .5, .25, 0], [0, .25, .5, .25], [.25, 0, .25, .5]],
        [[1, -1, 0, 0], [0, 1, -1, 0], [0, 0, 1, -1]], why="the mean, at 1, is hidden")
    for lam in (0, .5, .99, 1, -1, 1.01, 2):                                # one hidden mode driven by two visible states
        F, t = M([[1, 1, 0], [0, .5, 0], [.25, 1, 0]]), type(lam) is int or lam == .5
        F[2, 2] = M([[lam]])[0]; add(f"hidden-mode-{lam}", F, e(3, 0), hide=t, why="a hidden mode that decays, stays or grows")
        add(f"hidden-mode-{lam}-stays-noise-free", D(.5, F[2, 2]), e(2, 0), D(1, 0), hide=t, why="the hidden mode has no noise")
    for tag, b in (("decays", C(.5, 0)), ("on-circle", circle), ("grows", C(2, 0)), ("just-inside", C(1 - 2**-40, -1.5)), ("just-outside", C(1 + 2**-40, -1.5))):
        add(f"complex-hidden-{tag}", D(J(.5, 2), b), e(4, 0), hide="just" not in tag, why="a pair of complex modes is hidden")
        if "just" in tag: add(f"complex-read-{tag}-no-noise", b, e(2, 0), 0, why="an unreached pair next to the circle")
    for eps in (1e-3, 1e-6, 1e-12):                                         # nearly unobservable
        for lam in (.5, 1, 2): add(f"weak-reading-{eps}-of-{lam}", D(.25, lam), [[1, eps]], why=f"the coupling is {eps}")
        add(f"weak-chain-{eps}", [[.5, eps], [0, 1]], e(2, 0), why=f"the coupling is {eps}")
        add(f"weak-noise-{eps}", D(.5, 1), [[1, 1]], M([[1, 0], [0, eps]]), why=f"noise of variance {eps} on the mode at 1")
    for lam in (.5, 1, 2):                                                  # repeated eigenvalues, not defective
        both(f"twice-{lam}-one-output", D(lam, lam), [[1, 2]], why="two modes, one output: one is hidden")
        add(f"twice-{lam}-two-outputs", D(lam, lam), [[1, 2], [1, 1]], why="geometric multiplicity 2, two outputs")
        add(f"chain2+1-at-{lam}-one-output", D(J(lam, 2), lam), [[1, 0, 1]], why="geometric multiplicity 2 of 3")
        add(f"chain2+1-at-{lam}-two-outputs", D(J(lam, 2), lam), [[1, 0, 0], [1, 0, 1]], hide=True, why="geometric multiplicity 2 of 3")
    add("chains2+2-at-1-two-outputs", D(J(1, 2), J(1, 2)), e(4, 0, 2), hide=True); add("chains2+2-at-1-one-output", D(J(1, 2), J(1, 2)), [[1, 0, 1, 0]])
    add("H-dependent-rows", D(.5, .25, 2), [[1, 1, 1], [2, 2, 2], [0, 0, 0], [-1, -1, -1]], hide=True, why="four outputs, rank one, distinct modes: observable")
    add("H-dependent-rows-hides", D(.5, .5, 2), [[1, 1, 1], [2, 2, 2], [-3, -3, -3]], why="rank one and a repeated mode")
    add("H-dependent-in-decimals", sp.eye(2), [[.1, .3], [.7, 2.1]], why="rows dependent as decimals, not as binary64 numbers")
    add("F-singular-in-decimals", [[.1, .3], [.7, 2.1]], [[7, -1]], why="H F = 0 as decimals, not as binary64 numbers")
    add("H-zero-stable", D(.5, J(.25, 2)), [[0, 0, 0]]); add("H-zero-two-rows-grows", D(.5, 2), [[0, 0], [0, 0]]); add("H-zero-F-zero", sp.zeros(2), [[0, 0]], 0)
    add("F-zero-read", sp.zeros(3), e(3, 0, 1, 2), 0); add("F-zero-half-read", sp.zeros(2), e(2, 0))
    both("nilpotent-hidden-integrator-read", D(1, J(0, 2)), e(3, 0), why="the hidden part dies in two steps")
    add("nilpotent-feeds-integrator", M([[1, 0, 1], [0, 0, 1], [0, 0, 0]]), e(3, 0), D(0, 0, 1), hide=True, why="delay line into an integrator")
    tanks = M([[.5, .25], [.25, .5]]); add("two-tanks-sum-read", tanks, [[1, 1]], why="the difference, at .25, is hidden")
    add("sum-read-hides-1", [[1.5, .5], [.5, 1.5]], [[1, 1]], why="the difference, at 1, is hidden")
    add("difference-read-hides-2", [[1.5, .5], [.5, 1.5]], [[1, -1]], why="the sum, at 2, is hidden")
    both("grows-read-no-noise", D(2, .5), [[1, 1]], 0, why="2 and 1/2 with V = 0: the limit is not 0"); add("grows-and-integrator-no-noise", D(2, 1), [[1, 1]], 0)
    add("grows-integrator-decays-noise-on-decays", D(2, 1, .5), [[1, 1, 1]], D(0, 0, 1), hide=True, why="noise reaches only what decays")
    add("noise-rank-1-cancels-mode-1", D(1, 2), [[1, 1]], D(0, 4)); add("noise-rank-1-misses-mode-1", [[0, 2], [-1, 3]], [[1, 0]], [[4, 4], [4, 4]], why="V = b b', (1,-1) b = 0")
    add("minus-one-unreached-read", D(-1, .5), [[1, 1]], D(0, 1), hide=True); add("correlated-W", J(1, 2), [[1, 0], [1, 1]], W=[[2, 1], [1, 1]], why="W is not diagonal")
    k = 2.0**20                                                             # scales: millimetres and kilometres
    add("mm-km-integrator", M([[1, k], [0, 1]]), e(2, 0), W=1e-8); add("km-mm-integrator", M([[1, 1 / k], [0, 1]]), e(2, 0), M([[1e-8, 0], [0, 1e8]]), W=1e8)
    add("mm-km-chain4", M([[1, k, 0, 0], [0, 1, 1 / k, 0], [0, 0, 1, k], [0, 0, 0, 1]]), e(4, 0), why="observable, entries 1e-6 to 1e6")
    add("scaled-hidden-integrator", M([[.5, 1e8, 0], [0, .25, 0], [1e-8, 0, 1]]), [[1e-8, 0, 0]], why="hidden mode at 1 behind entries 1e-8 to 1e8")
    add("scaled-hidden-decay", M([[1, 1e8, 0], [0, .25, 0], [1e8, 0, .5]]), [[1e-8, 0, 0], [1e8, 0, 0]], W=[[1e-16, 0], [0, 1e16]])
    add("W-scales", D(J(1, 2), .5), [[1, 0, 0], [0, 0, 1], [1, 1, 0]], W=D(1e-16, 1e16, 1)); add("V-tiny-W-huge", J(1, 2), e(2, 0), 2.0**-40, W=2.0**40)

# ---------------------------------------------------------------- first way: exact rational arithmetic
def chain(F, H): return sp.Matrix.vstack(*[H * F**i for i in range(F.rows)])                # observability matrix
def on(F, N): return (N.T * N).inv() * N.T * F * N                                          # F on the invariant subspace N
def basis(A): v = A.nullspace(); return sp.Matrix.hstack(*v) if v else sp.zeros(A.cols, 0)
def circle(f):
    """Exact number of roots (inside, on, outside) the unit circle of an irreducible polynomial."""
    c, d = [sp.Rational(v) for v in f.all_coeffs()], f.degree()
    if d == 1: r = abs(c[1] / c[0]); return (int(bool(r < 1)), int(bool(r == 1)), int(bool(r > 1)))
    if c == c[::-1]:                            # self-reciprocal: put t = z + 1/z; roots t in (-2, 2) are pairs on the circle (Sturm)
        g, h = sp.Symbol("t"), d // 2; cheb = [sp.Integer(2), g]
        for _ in range(h): cheb.append(sp.expand(g * cheb[-1] - cheb[-2]))
        q = sp.Poly(c[h] + sum(c[h - i] * cheb[i] for i in range(1, h + 1)), g)
        m = 2 * int(q.count_roots(-2, 2)); return ((d - m) // 2, m, (d - m) // 2)
    low = lambda v: sp.Matrix(d, d, lambda i, j: v[i - j] if i >= j else 0)                  # Schur-Cohn matrix: its signature counts
    A, B = low(c[:d]), low(c[:0:-1]); q = sp.Poly((A * A.T - B * B.T).charpoly(z).as_expr(), z).all_coeffs()
    s = [sp.sign(v) for v in q if v != 0]; assert q[-1] != 0                                # Descartes is exact: all roots are real
    inside = sum(a != b for a, b in zip(s, s[1:])); return (inside, 0, d - inside)
def unseen(F, H):
    """Unobservable subspace, its (inside, on, outside) counts, the polynomial of its modes on the circle."""
    N = basis(chain(F, H)); count, f = [0, 0, 0], sp.Poly(1, z)
    if N.cols:
        for g, m in sp.Poly(on(F, N).charpoly(z).as_expr(), z, domain="QQ").factor_list()[1]:
            c = circle(g); count = [a + m * b for a, b in zip(count, c)]; f = f * g if c[1] else f
    return N, tuple(count), f
def at(f, A):                                                                                # polynomial of a matrix
    r = sp.zeros(A.rows)
    for c in f.all_coeffs(): r = r * A + c * sp.eye(A.rows)
    return r
def riccati(F, V, N, count, f):
    """From P = I: 'limit', 'bounded' or 'diverges', and how it was decided. README.md has the argument."""
    if count[1] + count[2] == 0: return "limit", "theorem: detectable"
    if count[2]: return "diverges", "theorem: hidden growing mode"
    L = unseen(F.T, V)[0]                                                                    # q in L: noise never reaches q'x
    K = N * basis(at(f**F.rows, on(F, N)))                                                   # hidden modes on the circle
    Q = L * basis(at(f, on(F.T, L))) if L.cols else L                                        # left eigenvectors (no chains) in L
    if not Q.cols or (Q.T * K).rank() < K.cols: return "diverges", "argument: hidden mode on the circle is fed"
    if f.degree() == 1: return "limit", "argument: constant hidden part"
    A, S = on(F.T, Q), Q.T * Q
    if sp.Matrix.hstack(N, Q).rank() > N.cols: return None, "numeric"                        # left to the second way
    return ("limit" if A.T * S * A == S else "bounded"), "argument: turning hidden part"
def semidefinite(V): q = sp.Poly(V.charpoly(z).as_expr(), z).all_coeffs(); return V == V.T and all(a * (-1)**i >= 0 for i, a in enumerate(q))

# ---------------------------------------------------------------- second way: 60 digits and more, from F, G, H, V, W alone
def X(A): return mp.matrix([[mp.mpf(int(v.p)) / int(v.q) for v in A.row(i)] for i in range(A.rows)])
def sv(A): return sorted((mp.svd_c(A, compute_uv=False) if A.rows >= A.cols else mp.svd_c(A.H, compute_uv=False)), reverse=True)
def ratio(F, H):                                                           # rank of [H; HF; ...] and its least nonzero singular value / largest
    if not H.rows: return 0, mp.mpf(1)
    with mp.workdps(120): A, B, rows = X(F), X(H), []; [rows.extend((B * A**i).tolist()) for i in range(F.rows)]; s = sv(mp.matrix(rows))
    r = sum(v > s[0] * mp.mpf("1e-50") for v in s); return r, (s[r - 1] / s[0] if r else mp.mpf(1))
def pbh(F, H, zs):                                                         # least distance to a hidden mode at one of the points zs
    n, best = F.rows, mp.inf; size = max(sv(F)[0], sv(H)[0], mp.mpf("1e-300"))
    for s in zs:
        A = mp.zeros(n + H.rows, n); A[:n, :] = F - s * mp.eye(n); A[n:, :] = H; best = min(best, sv(A)[-1] / size)
    return min(best, mp.mpf(1))
def step(P, F, H, V, W):                                                   # P(k+1|k) from P(k|k-1); lists of numbers, W diagonal
    n = len(F); P = [r[:] for r in P]
    for h, w in zip(H, W):
        g = [sum(a * b for a, b in zip(r, h)) for r in P]; s = w + sum(a * b for a, b in zip(g, h))
        P = [[P[i][j] - g[i] * g[j] / s for j in range(n)] for i in range(n)]
    A = [[sum(F[i][k] * P[k][j] for k in range(n)) for j in range(n)] for i in range(n)]
    P = [[V[i][j] + sum(A[i][k] * F[j][k] for k in range(n)) for j in range(n)] for i in range(n)]
    return [[P[min(i, j)][max(i, j)] for j in range(n)] for i in range(n)]  # one triangle: else rounding grows like F^k through P - P'
def big(A): return max(abs(v) for v in A)
def run(F, H, V, W, P0, steps=5000, doublings=160):
    """5000 steps with 60 digits, then 2^160 more by doubling with 1200 digits: (verdict, P, P(5000), closed loop F(I-KH))."""
    L, d = W.LDLdecomposition() if W.rows > 1 else (sp.eye(1), W); n = F.rows
    low = [[list(map(mp.mpf, r)) for r in X(a).tolist()] for a in (F, L.inv() * H, V)] + [[X(d)[i, i] for i in range(d.rows)]]
    P = step(X(sp.eye(n)).tolist(), low[0], [], low[2], []) if P0 == "belief" else X(sp.eye(n)).tolist()
    for _ in range(steps): P = step(P, *low)
    p5000 = mp.matrix(P)
    with mp.workdps(1200):
        Fm, Hm, Vm, Wm, E = X(F), X(H), X(V), X(W), mp.eye(n)
        def gain(P): S = Hm * P * Hm.T + Wm; return Fm * P * Hm.T * S**-1, S
        def phi(P): K, S = gain(P); A = Fm - K * Hm; return A * P * A.T + K * Wm * K.T + Vm
        B = (p5000 + p5000.T) / 2; K, S = gain(B); A, G, Q = (Fm - K * Hm).T, Hm.T * S**-1 * Hm, phi(B) - B
        for i in range(doublings + 1):
            last = B + Q
            try: I = (E + G * Q)**-1
            except ZeroDivisionError: return "diverges", None, p5000, None
            A, G, Q = A * I * A, G + A * I * G * A.T, Q + A.T * Q * I * A
            if big(Q) > mp.mpf(10)**300: return "diverges", None, p5000, None
            if i > 20 and big(A) < mp.mpf(10)**-600: break
        P = B + Q; P1 = phi(P); P3 = phi(phi(P1)); tol = mp.mpf(10)**-12 * (big(P) + mp.mpf(10)**-20)
        if big(P) > 1.5 * big(last) and big(P) > 1e3: return "diverges", None, p5000, None
        still = max(big(P1 - P), big(P3 - P), big(P - last)) < tol
        return ("limit" if still else "bounded"), P, p5000, Fm - gain(P)[0] * Hm
def eigs(A):
    with mp.workdps(400): return [mp.mpc(v) for v in mp.eig(A, left=False, right=False)] if A.rows > 1 else [mp.mpc(A[0])]
def clip(lam): return lam / abs(lam) if abs(lam) > 0 else mp.mpf(1)
def scale(F, H, cols):                                                     # units by powers of two: outputs, then states
    p2 = lambda v: sp.Integer(2) ** int(mp.nint(-mp.log(v, 2))) if v else sp.Integer(1); norm = lambda a: X(sp.Matrix([[sum(v * v for v in a)]]))[0] ** .5
    H = sp.Matrix.vstack(*[H.row(i) * p2(norm(H.row(i))) for i in range(H.rows)]) if H.rows else H
    O = chain(F, H); d = sp.diag(*[p2(norm(O.col(j))) for j in range(O.cols)]) if cols else sp.eye(F.rows)
    return d.inv() * F * d, H * d

def judge(s, F, G, H, V, W):
    n = F.rows; assert semidefinite(V) and semidefinite(W) and W.det() != 0
    O, R, noise = chain(F, H), chain(F.T, G.T), chain(F.T, V)
    N, hid, f = unseen(F, H); _, unr, _ = unseen(F.T, V)
    det, stab, marg = hid[1] + hid[2] == 0, unr[1] + unr[2] == 0, unr[1] > 0
    lim, how = riccati(F, V, N, hid, f); rank, rankC = O.rank(), R.rank() if R.rows else 0
    # second way
    lam = eigs(X(F)); tiny = mp.mpf("1e-45"); Vh = X(V)
    bad = [v for v in lam if abs(v) > 1 - tiny]; circ = [v for v in lam if abs(abs(v) - 1) < tiny]
    with mp.workdps(200):
        d2, s2, m2 = pbh(X(F), X(H), bad) > tiny, pbh(X(F).T, Vh, bad) > tiny, bool(circ) and pbh(X(F).T, Vh, circ) < tiny
    lim2, P, p5000, loop = run(F, H, V, W, "belief"); lim3, Pp, _, _ = run(F, H, V, W, "predicted", 300)
    radius = max(map(abs, eigs(loop))) if lim2 == "limit" else None
    same = [(rank, ratio(F, H)[0]), (rankC, ratio(F.T, G.T)[0]), (noise.rank(), ratio(F.T, V)[0]), (det, d2), (stab, s2), (marg, m2),
            (lim or lim2, lim2), (lim or lim3, lim3), (det and not marg, radius is not None and radius < 1 - mp.mpf("1e-19"))]
    for what, (a, b) in zip("rank rankC rankV detectable stabilizable unreached limit limit-from-predicted stabilizing".split(), same):
        if a != b: print("DISAGREE", s["name"], what, "exact:", a, "second way:", b, flush=True)
    # how far is another verdict: 0 when the answer hangs on |lambda| = 1 exactly
    hl, ul = (eigs(X(on(A, B))) if B.cols else [] for A, B in ((F, N), (F.T, basis(noise))))
    small = lambda v, to=tiny: float(v) if abs(v) > to else 0.0
    def margins(scaled):
        Fo, Ho = scale(F, H, scaled) if scaled else (F, H); Fc, Gc = scale(F.T, G.T, True) if scaled and G.cols else (F.T, G.T)
        Fv, Vv = scale(F.T, V, True) if scaled else (F.T, V); edge = [v if abs(v) > 1 else clip(v) for v in lam]
        m = dict(observable=ratio(Fo, Ho)[1], controllable=ratio(Fc, Gc)[1],
                 detectable=pbh(X(Fo), X(Ho), edge) if det else max(abs(v) - 1 for v in hl),
                 stabilizable=pbh(X(Fv), X(Vv), edge) if stab else max(abs(v) - 1 for v in ul),
                 unreached_on_circle=mp.mpf(0) if marg else pbh(X(Fv), X(Vv), map(clip, lam)))
        m["riccati"] = m["detectable"]; m["stabilizing"] = min(m["detectable"], m["unreached_on_circle"]) if det else m["detectable"]
        m = {a: small(mp.mpf(mp.nstr(b, 6))) for a, b in m.items()}; m["least"] = min(m.values()); return m
    num = lambda A: [[small(A[i, j], mp.mpf("1e-30")) for j in range(n)] for i in range(n)]
    s.update(n=n, p=H.rows, m=G.cols, observable=rank == n, observability_rank=rank,
        unobservable_basis=[[float(v / max(map(abs, N.col(j)))) for v in N.col(j)] for j in range(N.cols)], 
        unobservable_basis_exact=[[str(v) for v in N.col(j)] for j in range(N.cols)],
        hidden_modes=dict(zip(("inside", "on_circle", "outside"), hid)), detectable=det, controllable=rankC == n, controllability_rank=rankC,
        noise_rank=noise.rank(), unreached_modes=dict(zip(("inside", "on_circle", "outside"), unr)), stabilizable=stab, unreached_on_circle=marg,
        riccati=lim or lim2, riccati_decided_by=how, stabilizing=det and not marg, exponential=det and not marg,
        eigenvalues=[[small(v.real), small(v.imag)] for v in sorted(lam, key=lambda v: (-float(abs(v)), -float(v.imag), float(v.real)))],
        limit_P=num(P) if lim2 == "limit" else None,
        limit_same_from_predicted_I=bool(big(P - Pp) < mp.mpf("1e-12") * (big(P) + mp.mpf("1e-20"))) if lim2 == lim3 == "limit" else None,
        closed_loop_radius=small(radius) if radius is not None else None, off_limit_after_5000=float(mp.nstr(big(p5000 - P) / max(big(P), mp.mpf(1)), 6)) if lim2 == "limit" else None,
        margin=margins(False), margin_scaled=margins(True), second_way_agrees=all(a == b for a, b in same))
    return s

if __name__ == "__main__":
    mp.mp.dps = 60; build(); out = []
    for x in SYSTEMS:
        out.append(judge(*x)); print(len(out), out[-1]["name"], out[-1]["riccati"], flush=True)
    open("systems.json", "w").write("[\n" + ",\n".join(map(json.dumps, out)) + "\n]\n")
    print(len(out), "systems,", sum(not s["second_way_agrees"] for s in out), "disagreements")

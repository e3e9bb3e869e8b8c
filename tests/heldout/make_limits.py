"""Writes limits.json: linear systems, and the limit of P(k+1 | k) and of the gain of each, to 50 digits and more.

python make_limits.py        (Python 3.11, mpmath 1.4; with gmpy2 it is faster; some minutes)

The limit is found by doubling with 160 digits, and does not rest on that: it is kept only where it satisfies the Riccati
equation to 60 digits and where the powers of F(I - KH) die out, also by 60 digits. One matrix alone does both.
"""
import json
import pathlib
import random

from mpmath import mp, mpf

DIGITS = 160
mp.dps = DIGITS
KEPT = mpf(10) ** -60
NUDGE = mpf(10) ** -40


def product(a, b):
    columns = list(zip(*b))
    return [[mp.fdot(row, column) for column in columns] for row in a]


def turned(a):
    return [list(row) for row in zip(*a)]


def plus(a, b, sign=1):
    return [[x + sign * y for x, y in zip(r, s)] for r, s in zip(a, b)]


def unit(n):
    return [[mpf(int(i == j)) for j in range(n)] for i in range(n)]


def solved(a, b):
    """a^-1 b by elimination with the largest pivots."""
    n = len(a)
    rows = [list(r) + list(s) for r, s in zip(a, b)]
    for j in range(n):
        pivot = max(range(j, n), key=lambda i: abs(rows[i][j]))
        rows[j], rows[pivot] = rows[pivot], rows[j]
        rows[j] = [x / rows[j][j] for x in rows[j]]
        for i in range(n):
            if i != j and rows[i][j] != 0:
                factor = rows[i][j]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[j])]
    return [row[n:] for row in rows]


def largest(a):
    return max(abs(x) for row in a for x in row)


def gain(p, h, w):
    hp = product(h, p)
    return turned(solved(plus(product(hp, turned(h)), w), hp))


def advance(p, f, h, v, w):
    k = gain(p, h, w)
    rest = plus(p, product(k, product(h, p)), -1)
    q = plus(product(product(f, rest), turned(f)), v)
    return [[(x + y) / 2 for x, y in zip(r, s)] for r, s in zip(q, turned(q))], k


def limit(f, h, v, w):
    """From P(0 | 0) = I: eight steps, then doublings of the change from there."""
    n = len(f)
    p = plus(product(f, turned(f)), v)
    for _ in range(8):
        p, k = advance(p, f, h, v, w)
    q, k = advance(p, f, h, v, w)
    a = turned(plus(f, product(f, product(k, h)), -1))
    g = product(turned(h), solved(plus(product(h, product(p, turned(h))), w), h))
    e = plus(q, p, -1)
    for _ in range(64):
        inner = plus(unit(n), product(g, e))
        z = solved(inner, [x + y for x, y in zip(a, g)])
        az, gz = [row[:n] for row in z], [row[n:] for row in z]
        more = product(turned(a), product(e, az))
        g = plus(g, product(a, product(gz, turned(a))))
        e = plus(e, more)
        a = product(a, az)
        if largest(more) < KEPT * KEPT * largest(plus(p, e)) and largest(a) < KEPT:
            break
    return plus(p, e)


def own(p, i, j):
    return mp.sqrt(abs(p[i][i] * p[j][j]))


def proved(p, f, h, v, w):
    """Whether P satisfies the equation, and the closed loop dies out."""
    n = len(f)
    q, k = advance(p, f, h, v, w)
    if any(abs(q[i][j] - p[i][j]) > KEPT * own(p, i, j) for i in range(n) for j in range(n)):
        return False
    a = plus(f, product(f, product(k, h)), -1)
    for _ in range(48):
        a = product(a, a)
        if largest(a) < KEPT:
            return True
    return False


def exact(m):
    return [[mpf(x) for x in row] for row in m]


def answered(name, f, h, v, w):
    """The row of the file, or None where the limit was not proved."""
    given = [exact(m) for m in (f, h, v, w)]
    p = limit(*given)
    if not proved(p, *given) or min(p[i][i] for i in range(len(f))) <= 0:
        return None
    k = gain(p, given[1], given[3])
    s = plus(product(given[1], product(p, turned(given[1]))), given[3])
    # How much a change of every number by a part of its size changes the answer, in units of its own.
    dice = random.Random(7)
    sign = {}
    def nudged(m, symmetric=False):
        def one(i, j):
            key = (id(m), min(i, j), max(i, j)) if symmetric else (id(m), i, j)
            sign.setdefault(key, dice.choice((-1, 1)))
            return m[i][j] * (1 + sign[key] * NUDGE)
        return [[one(i, j) for j in range(len(m[0]))] for i in range(len(m))]
    other = [nudged(given[0]), nudged(given[1]), nudged(given[2], True), nudged(given[3], True)]
    q = limit(*other)
    l = gain(q, other[1], other[3])
    n, o = len(f), len(h)
    off = max(abs(p[i][j] - q[i][j]) / own(p, i, j) for i in range(n) for j in range(n))
    off = max([off] + [abs(k[i][j] - l[i][j]) * mp.sqrt(s[j][j] / p[i][i]) for i in range(n) for j in range(o)])
    number = lambda x: float(mp.nstr(x, 25))
    return {
        "name": name, "F": f, "H": h, "V": v, "W": w,
        "P": [[number(p[i][j]) for j in range(i + 1)] for i in range(n)],
        "K": [[number(x) for x in row] for row in k],
        "condition": float(mp.nstr(off / NUDGE, 3)),
    }


def rounded(m):
    """Whole numbers without their point, so that the file is short; all are exact."""
    return [[int(x) if x == int(x) and abs(x) < 1e9 else x for x in row] for row in m]


def square(b, scale):
    """b bT * scale, exact: few bits each."""
    return [[sum(x * y for x, y in zip(r, s)) * scale for s in b] for r in b]


def by_lot(dice):
    n = dice.choice((1, 2, 2, 3, 3, 4, 4, 5, 6, 7, 9))
    p, q = dice.randint(1, min(3, n)), dice.randint(1, n)
    size = 64 * n ** 0.5 / dice.choice((0.6, 0.9, 1.0, 1.2))
    f = [[round(dice.gauss(0, 64)) / 2 ** round(size).bit_length() for _ in range(n)] for _ in range(n)]
    h = [[dice.choice((0, 0, 1, 1, -1, 2)) for _ in range(n)] for _ in range(p)]
    h = [row if any(row) else [1] * n for row in h]
    v = square([[dice.randint(-4, 4) for _ in range(q)] for _ in range(n)], 2.0 ** dice.randint(-12, 2))
    c = [[(dice.randint(1, 4) if i == j else dice.randint(-1, 1)) if j <= i else 0 for j in range(p)] for i in range(p)]
    w = square(c, 2.0 ** dice.randint(-6, 3))
    return f, h, v, w


def chain(n, dt):
    f = [[0.0] * n for _ in range(n)]
    for i in range(n):
        term = 1.0
        for j in range(i, n):
            f[i][j] = term
            term *= dt / (j - i + 1)
    return f


def diagonal(entries):
    return [[float(x) if i == j else 0.0 for j in range(len(entries))] for i, x in enumerate(entries)]


def hard():
    # A height, its speed and the bias of the accelerometer, at many rates; the bias wanders ever more slowly.
    for dt in (0.1, 0.01, 0.001):
        for q in (1e-6, 1e-8, 1e-10, 1e-12):
            f = [[1.0, dt, -dt * dt / 2], [0.0, 1.0, -dt], [0.0, 0.0, 1.0]]
            a = [dt * dt / 2, dt, 0.0]
            v = [[0.04 * a[i] * a[j] for j in range(3)] for i in range(3)]
            v[2][2] += q * dt
            yield f"height, dt {dt}, bias {q}", f, [[1.0, 0.0, 0.0]], v, [[0.25]]
    # Chains of integrators whose last state alone is disturbed.
    for n in (2, 3, 4, 5, 6):
        for dt in (0.5, 0.05, 0.005):
            yield f"chain of {n}, dt {dt}", chain(n, dt), [[1.0] + [0.0] * (n - 1)], \
                diagonal([0.0] * (n - 1) + [1e-3 * dt]), [[1.0]]
    # The noise dies away: the filter listens ever less.
    for q in (1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14):
        yield f"random walk, noise {q}", [[1.0]], [[1.0]], [[q]], [[1.0]]
        yield f"two walks, one reading, noise {q}", [[1.0, 0.0], [0.0, 0.75]], [[1.0, 1.0]], \
            diagonal([q, 0.0625]), [[1.0]]
    # An unstable state that no noise reaches: only a start that is large enough finds the limit.
    for grow in (1.001, 1.01, 1.1, 1.5, 2.0, 4.0):
        yield f"unstable {grow} without noise", [[grow, 0.0], [0.25, 0.5]], [[1.0, 0.0]], diagonal([0.0, 0.5]), [[2.0]]
        yield f"unstable {grow}, seen through another", [[0.5, 1.0], [0.0, grow]], [[1.0, 0.0]], \
            diagonal([0.25, 0.0]), [[1.0]]
    # Units that differ by many decades.
    for k in (2, 4, 6, 8, 10):
        d = [10.0 ** -k, 1.0, 10.0 ** k]
        f = chain(3, 0.125)
        yield f"units of 10^{k}", [[f[i][j] * (d[i] / d[j]) for j in range(3)] for i in range(3)], \
            [[1.0 / d[0], 0.0, 0.0]], diagonal([0.0, 0.0, 0.0625 * d[2] * d[2]]), [[0.25]]
        yield f"units of 10^-{k}", [[f[i][j] * (d[j] / d[i]) for j in range(3)] for i in range(3)], \
            [[d[0], 0.0, 0.0]], diagonal([0.0, 0.0, 0.0625 / d[2] / d[2]]), [[0.25]]
    # An oscillator that hardly loses anything, and one that gains.
    for damp in (0.5, 0.9, 0.99, 0.999, 0.99999, 1.0, 1.001):
        yield f"oscillator {damp}", [[damp * 0.8, damp * 0.6], [-damp * 0.6, damp * 0.8]], [[1.0, 0.0]], \
            diagonal([0.0, 1e-5]), [[1.0]]
    # What is read next to nothing of, and readings that are next to exact.
    for weak in (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6):
        yield f"coupled by {weak}", [[0.9, weak], [0.0, 0.99]], [[1.0, 0.0]], diagonal([1e-2, 1e-2]), [[1.0]]
        yield f"reading to {weak}", chain(2, 0.1), [[1.0, 0.0]], diagonal([0.0, 0.01]), [[weak ** 4]]
    # Readings without noise, and states that a reading tells at once.
    yield "no noise of the reading", chain(2, 0.5), [[1.0, 0.0]], diagonal([0.25, 0.25]), [[0.0]]
    yield "all read without noise", [[0.9, 0.5], [-0.25, 1.1]], [[1.0, 0.0], [0.0, 1.0]], diagonal([1.0, 4.0]), \
        diagonal([0.0, 0.0])
    # Large systems: chains side by side, tied together.
    for n, dt in ((9, 0.1), (9, 0.01), (12, 0.1), (16, 0.25)):
        f = diagonal([1.0] * n)
        for i in range(n - 1):
            if i % 3 != 2:
                f[i][i + 1] = dt
        for i in range(2, n, 3):
            f[i][i] = 0.96875
        h = [[1.0 if j == i else 0.0 for j in range(n)] for i in range(0, n, 3)]
        yield f"{n} states in threes, dt {dt}", f, h, \
            diagonal([0.0 if i % 3 != 2 else dt / 64 for i in range(n)] if n % 3 == 0
                     else [0.0 if i % 3 != 2 and i != n - 1 else dt / 64 for i in range(n)]), diagonal([0.5] * len(h))
    # Jordan blocks near and on the circle.
    for n in (2, 3, 4):
        for at in (0.5, 0.875, 1.0, 1.0625):
            f = [[at if i == j else float(j == i + 1) for j in range(n)] for i in range(n)]
            yield f"Jordan block of {n} at {at}", f, [[1.0] + [0.0] * (n - 1)], diagonal([1.0 / 16] * n), [[4.0]]


def main():
    rows = []
    for name, *system in hard():
        row = answered(name, *(rounded(m) for m in system))
        print(name, "condition", row and row["condition"])
        if row:
            rows.append(row)
    count = len(rows)
    dice = random.Random(27)
    while len(rows) < count + 500:
        row = answered(f"by lot {len(rows) - count}", *(rounded(m) for m in by_lot(dice)))
        if row:
            rows.append(row)
        if len(rows) % 50 == 0:
            print(len(rows))
    text = ",\n".join(json.dumps(row, separators=(",", ":")) for row in rows)
    pathlib.Path(__file__).with_name("limits.json").write_text(f"[\n{text}\n]\n")
    print(count, "hard ones, and", len(rows) - count, "by lot")


if __name__ == "__main__":
    main()

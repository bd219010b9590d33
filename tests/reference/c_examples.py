"""Writes c_examples.csv: what docs/examples print, by mpmath alone: python3 c_examples.py > c_examples.csv

program, the word before the number, and the digits that it begins with. The pendulum by Jacobi's functions at 80
digits, Lorenz by mpmath's Taylor series, the rest by closed forms; three digits fewer than are printed.
"""
from mpmath import asin, ellipfun, ellipk, gamma, mp, mpf, nstr, odefun, pi, sin, sqrt, tan

mp.dps = 80


def cut(value, digits):
    """The first digits of a number, not rounded."""
    text = nstr(value, digits + 15, strip_zeros=False, min_fixed=-1000, max_fixed=1000)
    kept, count, leading = "", 0, True
    for letter in text:
        if letter.isdigit():
            leading = leading and letter == "0"
            count += 0 if leading else 1
        if count > digits:
            break
        kept += letter
    return kept


def theta(time):
    """Of the pendulum from rest at 90 degrees: 2 asin(k cd(t, k))."""
    k = sin(pi / 4)
    period = 4 * ellipk(k * k)
    t = time - period * int(time / period)
    return 2 * asin(k * ellipfun("cd")(t, m=k * k))


rows = [("in_c", "period", gamma(mpf(1) / 4) ** 2 / sqrt(pi), 37)]
rows.append(("in_c", "theta", theta(mpf(10) ** 12), 37))
rows.append(("in_c", "sampler", theta(mpf(0)), 12))
rows.append(("in_c", "sampler", theta(mpf(0.7)), 12))
rows.append(("in_c", "sampler", theta(mpf(10) ** 9), 12))
rows.append(("in_c", "x(1)", tan(1), 27))
rows.append(("in_c", "R >=", pi / 2, 9))
rows.append(("in_c", "R <=", pi / 2, 9))
rows.append(("in_fortran", "period", rows[0][2], 37))
rows.append(("in_fortran", "sampler", theta(mpf(0.7)), 12))
mp.dps = 45
lorenz = odefun(lambda t, y: [10 * (y[1] - y[0]), y[0] * (28 - y[2]) - y[1], y[0] * y[1] - mpf(8) / 3 * y[2]], 0, [1, 0, 0])
rows.append(("in_fortran", "x(2)", lorenz(2)[0], 27))
print("program,line,digits")
for program, line, value, digits in rows:
    print(f"{program},{line},{cut(value, digits)}")
print("in_c,a_7,17/315")

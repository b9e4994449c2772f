#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinetic Poiseuille flow rate Q_P(D) to many digits: variational principle of Cercignani & Pagani 1966.

Linearised BGK equation between diffusely reflecting plates at x = -D/2, D/2, with
T_n(x) = int_0^inf t^n exp(-t^2 - x/t) dt:

    psi = 1 + K psi,   (K psi)(x) = 1/sqrt(pi) int T_-1(|x - y|) psi(y) dy,   Q_P = [(1, psi) - D]/D^2.

With psi = A + B x^2 the stationary value of 2 (1, psi) - (psi, psi - K psi) gives (1, psi). The products are
integrals of a power of x times T_n, which integration by parts (T_n' = -T_(n-1)) turns into values of T_n at 0 and D.

Without arguments: the rows of core/physics/film/kinetic_flow_rate.cpp. With numbers: Q_P at these D.
Needs python3-mpmath.
"""
import sys

from mpmath import exp, factorial, gamma, log, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 40


def abramowitz(n, x):
    if x == 0:
        return gamma(mpf(n + 1) / 2) / 2
    places = sorted({0, min(sqrt(x), 1) / 10, x ** (mpf(1) / 3), 1, 2, 4, 8, 12})
    return quad(lambda t: t**n * exp(-t * t - x / t), places)


def flow_rate(D):
    D = mpf(D)
    a = D / 2
    at_zero = {n: abramowitz(n, 0) for n in range(0, 6)}
    at_d = {n: abramowitz(n, D) for n in range(0, 6)}

    def power_integral(k, n):
        """int_0^D s^k T_n(s) ds"""
        by_parts = sum(factorial(k) / factorial(k - j) * D ** (k - j) * at_d[n + 1 + j] for j in range(k + 1))
        return factorial(k) * at_zero[n + 1 + k] - by_parts

    def integral(coefficients, lowest, n):
        return sum(c * power_integral(lowest + i, n) for i, c in enumerate(coefficients))

    # (f, g - K g) = 1/(2 sqrt(pi)) int int T_-1(|x - y|) (f(x) - f(y)) (g(x) - g(y)) + int f g (1 - K 1),
    # 1 - K 1 = [T_0(D/2 - x) + T_0(D/2 + x)]/sqrt(pi); s = |x - y| in the double, D/2 - x in the single integral.
    c11 = 2 / sqrt(pi) * integral([1], 0, 0)
    c12 = 2 / sqrt(pi) * integral([a**2, -2 * a, 1], 0, 0)
    c22 = (mpf(8) / 3 * integral([a**3, -3 * a**2 / 2, 3 * a / 4, -mpf(1) / 8], 2, -1)
           + 2 * integral([a**4, -4 * a**3, 6 * a**2, -4 * a, 1], 0, 0)) / sqrt(pi)
    r1, r2 = D, D**3 / 12
    flow = (r1 * r1 * c22 - 2 * r1 * r2 * c12 + r2 * r2 * c11) / (c11 * c22 - c12 * c12)
    return (flow - D) / D**2


def main():
    if len(sys.argv) > 1:
        for argument in sys.argv[1:]:
            print(argument, nstr(flow_rate(argument), 12))
        return
    for k in range(49):
        x = log(mpf(10)) * (mpf(k) / 8 - 4)
        excess = lambda x: flow_rate(exp(x)) - exp(x) / 6
        slope = (excess(x + mpf(10) ** -8) - excess(x - mpf(10) ** -8)) / (2 * mpf(10) ** -8)
        print("{%.10f, %.10f}," % (excess(x), slope))


if __name__ == "__main__":
    main()

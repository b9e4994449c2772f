#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An independent integration of the 2-DOF spring model with located switches (SciPy's DOP853).

In nm, us and urad; forces in SI. Writes tests/simulation/springs/scipy_reference_<name>.csv: time [us], flying
height [nm], pitch [urad] and, as comments, the switches. Run from the project's folder; needs python3-scipy. The tests
compare with the stored files.
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp

# Parameters in SI, as the tests set them. None of them is the paper's.
CASES = {
    # Light slider with strong damping; the contact pad far back; springs that are lost and caught again at d_1.
    "light": dict(M=0.9e-6, J=0.8e-13, b=0.23e-3, df=0.31e-3, dr=0.37e-3, dh=0.41e-3, kf0=4.1e5, kr0=0.9e6,
                  xf=0.03, xr=0.04, d1=2.6e-9, FH=6e-9, th0=130e-6, k=11.0, kth=0.9e-4, xs=0.02, xth=0.03, fm=14e-3,
                  kc=3.3e6, fc0=4e-3, ds=2.8e-9, de=5.7e-9, mu=0.45, linear=False, h0=60e-9, pitch0=40e-6, vz=-0.02,
                  vth=60.0, T=300e-6),
    # Adhesion that falls linearly on take-off, and a start in contact.
    "linear": dict(M=1.5e-6, J=2.0e-13, b=0.3e-3, df=0.45e-3, dr=0.52e-3, dh=0.58e-3, kf0=6e5, kr0=1.2e6,
                   xf=0.02, xr=0.03, d1=0.5e-9, FH=8e-9, th0=100e-6, k=6.0, kth=1.5e-4, xs=0.01, xth=0.01, fm=6e-3,
                   kc=5e6, fc0=5e-3, ds=3e-9, de=5e-9, mu=0.3, linear=True, h0=2e-9, pitch0=100e-6, vz=0.0, vth=0.0,
                   T=200e-6),
}


def run(p):
    z0 = p["FH"] + p["dh"] * p["th0"]
    zf0, zr0 = z0 + p["df"] * p["th0"], z0 - p["dr"] * p["th0"]
    cf, cr = (2 * x * np.sqrt(p["M"] * k) for x, k in ((p["xf"], p["kf0"]), (p["xr"], p["kr0"])))
    c, cth = 2 * p["xs"] * np.sqrt(p["M"] * p["k"]), 2 * p["xth"] * np.sqrt(p["J"] * p["kth"])
    release = min(p["de"], p["ds"] + p["fc0"] / p["kc"])

    def places(y):
        z, th = y[0] * 1e-9, y[1] * 1e-6
        return z - p["dh"] * th, z + p["df"] * th, z - p["dr"] * th

    def rhs(t, y, mode):
        branch, front, rear = mode
        d, zf, zr = places(y)
        vz, vth = y[2] * 1e-3, y[3]  # nm/us = 1e-3 m/s, urad/us = rad/s
        ff = (p["kf0"] * zf0**2 / zf**2 * (zf0 - zf) if front else 0.0) - cf * (vz + p["df"] * vth)
        fr = (p["kr0"] * zr0**2 / zr**2 * (zr0 - zr) if rear else 0.0) - cr * (vz - p["dr"] * vth)
        fcr = p["fc0"] + p["kc"] * (p["ds"] - d) if branch in ("pressed", "lifting") else 0.0
        if branch == "free":
            fadh = 0.0
        elif branch == "pressed" or not p["linear"]:
            fadh = -p["fm"]
        else:
            fadh = -p["fm"] * (p["de"] - d) / (p["de"] - p["ds"])
        fc = fcr + fadh
        force = ff + fr + fc - p["k"] * (y[0] * 1e-9 - z0) - c * vz
        moment = (p["df"] * ff - p["dr"] * fr - p["dh"] * fc - 0.5 * p["b"] * p["mu"] * fcr
                  - p["kth"] * (y[1] * 1e-6 - p["th0"]) - cth * vth)
        # m/s^2 = 1e-3 nm/us^2, rad/s^2 = 1e-6 urad/us^2
        return [y[2], y[3], force / p["M"] * 1e-3, moment / p["J"] * 1e-6]

    def exits(mode):
        branch, front, rear = mode
        low = {"free": p["ds"], "pressed": None, "lifting": p["ds"], "bridged": release}[branch]
        high = {"free": None, "pressed": p["ds"], "lifting": release, "bridged": p["de"]}[branch]
        below = {"free": "pressed", "lifting": "pressed", "bridged": "lifting"}
        above = {"pressed": "lifting", "lifting": "bridged" if release < p["de"] else "free", "bridged": "free"}
        rows = []
        if low is not None:
            rows.append((0, low, -1, (below[branch], front, rear)))
        if high is not None:
            rows.append((0, high, +1, (above[branch], front, rear)))
        rows.append((1, p["d1"], -1 if front else +1, (branch, not front, rear)))
        rows.append((2, p["d1"], -1 if rear else +1, (branch, front, not rear)))
        return rows

    y = np.array([(p["h0"] + p["dh"] * p["pitch0"]) * 1e9, p["pitch0"] * 1e6, p["vz"] * 1e3, p["vth"]])
    d, zf, zr = places(y)
    mode = ("pressed" if d <= p["ds"] else "free", zf > p["d1"], zr > p["d1"])
    t, end = 0.0, p["T"] * 1e6
    grid = np.arange(0, round(end) + 1) * 1.0
    rows, switches = [], []
    while t < end:
        functions = []
        for place, level, direction, _ in exits(mode):
            f = lambda s, x, _, place=place, level=level: (places(x)[place] - level) * 1e9
            f.terminal, f.direction = True, direction
            functions.append(f)
        s = solve_ivp(rhs, (t, end), y, method="DOP853", rtol=1e-12, atol=[1e-11, 1e-12, 1e-11, 1e-11],
                      events=functions, dense_output=True, args=(mode,), max_step=0.5)
        inside = grid[(grid >= t) & (grid < s.t[-1])] if s.status == 1 else grid[(grid >= t) & (grid <= end)]
        for g in inside:
            x = s.sol(g)
            rows.append((g, places(x)[0] * 1e9, x[1]))
        t, y = s.t[-1], s.y[:, -1]
        if s.status != 1:
            break
        which = next(i for i, e in enumerate(s.t_events) if len(e))
        mode = exits(mode)[which][3]
        switches.append((t, mode))
    return rows, switches


for name, parameters in CASES.items():
    rows, switches = run(parameters)
    with open(f"tests/simulation/springs/scipy_reference_{name}.csv", "w") as out:
        for t, mode in switches:
            print(f"# switch at {t:.6f} us to {mode}", file=out)
        print("time [us],flying_height [nm],pitch [urad]", file=out)
        for row in rows:
            print(",".join(f"{x:.9f}" for x in row), file=out)
    print(name, len(rows), "rows", len(switches), "switches", rows[-1], file=sys.stderr)

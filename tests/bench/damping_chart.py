#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws results of `touchdown-bench --damping` as SVG: error of the damping ratio against processor time.

    damping_chart.py OUT.svg "NAME=FILE.csv" ...

One colour for each file. A mark is one mode of one slider at one step error; each line joins the medians over all modes
of a file, one for each step error, the dashed one the worst. Times are relative to the run of the same mode in the
first file at its largest step error. The error is the difference from `modes` on the same grid, against 5 % of the
damping ratio or 5e-5, whichever is larger: below 1 the run has the damping of its grid."""
import csv
import math
import statistics
import sys

COLOURS = ["#b5482a", "#1f6f8b", "#6a7f1e"]
WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 760, 460, 70, 44, 20, 56


def rows(path):
    """Of each run: (slider and mode, step error [nm], processor time [s/ms], error of what is allowed)."""
    with open(path, encoding="utf-8") as text:
        table = list(csv.DictReader(line for line in text if not line.startswith("#")))
    for row in table:
        ratio, difference = float(row["modes [%]"]), float(row["difference [%]"])
        allowed = max(0.05 * abs(ratio), 0.005)
        error = max(abs(difference) / allowed, 1e-3)
        yield (row["case"], row["mode"]), float(row["step error [nm]"]), float(row["processor time [s/ms]"]), error


def main():
    out, files = sys.argv[1], [argument.split("=", 1) for argument in sys.argv[2:]]
    found = [(name, list(rows(path))) for name, path in files]
    largest = max(step for _, step, _, _ in found[0][1])
    usual = {mode: time for mode, step, time, _ in found[0][1] if step == largest}
    data = [(name, [(step, time / usual[mode], error) for mode, step, time, error in runs if mode in usual])
            for name, runs in found]
    times = [time for _, runs in data for _, time, _ in runs]
    errors = [error for _, runs in data for _, _, error in runs]
    low, high = math.log10(min(times)) - 0.05, math.log10(max(times)) + 0.05
    bottom, top = -3.0, math.ceil(math.log10(max(errors)))

    def x(time):
        return LEFT + (math.log10(time) - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    def y(error):
        return TOP + (top - math.log10(error)) / (top - bottom) * (HEIGHT - TOP - BOTTOM)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" '
             'font-size="13">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>']

    def line(x1, y1, x2, y2, style):
        parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" {style}/>')

    def text(at, height, words, style=""):
        parts.append(f'<text x="{at:.1f}" y="{height:.1f}" {style}>{words}</text>')

    for power in range(int(bottom), int(top) + 1):
        line(LEFT, y(10.0**power), WIDTH - RIGHT, y(10.0**power), 'stroke="#dddddd"')
        text(LEFT - 8, y(10.0**power) + 4, f"{10.0**power:g}", 'text-anchor="end" fill="#444444"')
    for time in [0.5, 0.7, 1, 1.5, 2, 3, 5, 7, 10, 20]:
        if not low <= math.log10(time) <= high:
            continue
        line(x(time), TOP, x(time), HEIGHT - BOTTOM, 'stroke="#dddddd"')
        text(x(time), HEIGHT - BOTTOM + 18, f"{time:g}", 'text-anchor="middle" fill="#444444"')
    line(LEFT, y(1.0), WIDTH - RIGHT, y(1.0), 'stroke="#444444" stroke-dasharray="5 4"')
    text(WIDTH - RIGHT - 4, y(1.0) - 6, "allowed: 5 % of the damping ratio or 5e-5", 'text-anchor="end" fill="#444444"')
    text(0.5 * (LEFT + WIDTH - RIGHT), HEIGHT - 14, "processor time / that of the usual steps before",
         'text-anchor="middle"')
    text(18, 0.5 * (TOP + HEIGHT - BOTTOM), "error of the damping ratio / allowed",
         f'text-anchor="middle" transform="rotate(-90 18 {0.5 * (TOP + HEIGHT - BOTTOM):.1f})"')
    for number, (name, runs) in enumerate(data):
        colour = COLOURS[number % len(COLOURS)]
        for _, time, error in runs:
            place = f'cx="{x(time):.1f}" cy="{y(error):.1f}"'
            parts.append(f'<circle {place} r="3.2" fill="{colour}" fill-opacity="0.35"/>')
        medians, worst = [], []
        for step in sorted({step for step, _, _ in runs}):
            of_step = [(time, error) for other, time, error in runs if other == step]
            time = statistics.median(t for t, _ in of_step)
            medians.append((time, statistics.median(e for _, e in of_step)))
            worst.append((time, max(e for _, e in of_step)))
        for marks, style in (medians, 'stroke-width="2.5"'), (worst, 'stroke-width="1.5" stroke-dasharray="6 4"'):
            points = " ".join(f"{x(time):.1f},{y(error):.1f}" for time, error in marks)
            parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" {style}/>')
        for time, error in medians:
            parts.append(f'<circle cx="{x(time):.1f}" cy="{y(error):.1f}" r="5" fill="{colour}"/>')
        text(LEFT + 10 + 220 * number, TOP - 16, f"&#9679; {name}", f'fill="{colour}" font-weight="bold"')
    parts.append("</svg>")
    with open(out, "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")


main()

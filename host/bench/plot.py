# SPDX-License-Identifier: BSD-3-Clause
"""Curves as an SVG file, drawn the same on every run."""
import math
from html import escape
from pathlib import Path

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 360, 70, 20, 34, 48
COLOURS = ("#1f5fbf", "#c0392b", "#2e8b57", "#8e44ad")


def ticks(low, high, most=6):
    """Round numbers from low to high, at most that many and at least two where low < high."""
    if not low < high:
        raise ValueError(f"an axis from {low} to {high} has no length")
    step = 10.0 ** math.floor(math.log10((high - low) / most))
    for factor in (1, 2, 5, 10, 20):
        first, last = math.ceil(low / (step * factor) - 1e-9), math.floor(high / (step * factor) + 1e-9)
        if last - first < most:
            return [round(i * step * factor, 12) for i in range(first, last + 1)]
    raise ValueError(f"an axis from {low} to {high} has no ticks")


def curves_svg(title, x_label, y_label, curves, level=None):
    """The SVG of `curves`, a dictionary of names and [(x, y)]; `level`: (y, name) of a dashed line across."""
    points = [point for curve in curves.values() for point in curve]
    if not points:
        raise ValueError(f"'{title}' has no points")
    ys = [y for _, y in points] + ([level[0]] if level else [])
    x_low, x_high = min(x for x, _ in points), max(x for x, _ in points)
    y_low, y_high = min(ys), max(ys)
    y_low, y_high = (0 if 0 < y_low < (y_high - y_low) else y_low), y_high + 0.03 * (y_high - y_low)

    def place(x, y):
        across = (x - x_low) / (x_high - x_low) * (WIDTH - LEFT - RIGHT)
        return round(LEFT + across, 2), round(TOP + (y_high - y) / (y_high - y_low) * (HEIGHT - TOP - BOTTOM), 2)

    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
             'font-family="sans-serif" font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
             f'<text x="{WIDTH / 2}" y="20" text-anchor="middle" font-size="14">{escape(title)}</text>']
    for x in ticks(x_low, x_high, 10):
        left, _ = place(x, y_low)
        parts.append(f'<path d="M{left} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>'
                     f'<text x="{left}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{x:g}</text>')
    for y in ticks(y_low, y_high):
        _, down = place(x_low, y)
        parts.append(f'<path d="M{LEFT} {down}H{WIDTH - RIGHT}" stroke="#ddd"/>'
                     f'<text x="{LEFT - 6}" y="{down + 4}" text-anchor="end">{y:g}</text>')
    if level:
        _, down = place(x_low, level[0])
        parts.append(f'<path d="M{LEFT} {down}H{WIDTH - RIGHT}" stroke="#555" stroke-dasharray="5 4"/>'
                     f'<text x="{WIDTH - RIGHT}" y="{down - 5}" text-anchor="end" fill="#555">{escape(level[1])}</text>')
    for i, (name, curve) in enumerate(curves.items()):
        colour = COLOURS[i % len(COLOURS)]
        path = "L".join(f"{x} {y}" for x, y in (place(*point) for point in curve))
        parts.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>')
        middle = TOP + 60 + 18 * i
        parts.append(f'<path d="M{WIDTH - 240} {middle}h24" stroke="{colour}" stroke-width="2"/>'
                     f'<text x="{WIDTH - 210}" y="{middle + 4}">{escape(name)}</text>')
    parts.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">{escape(x_label)}</text>')
    parts.append(f'<text transform="translate(16 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">'
                 f'{escape(y_label)}</text></svg>')
    return "\n".join(parts) + "\n"


def write_curves(file, *arguments, **options):
    Path(file).write_text(curves_svg(*arguments, **options), encoding="utf-8")

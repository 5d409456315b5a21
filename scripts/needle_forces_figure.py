#!/usr/bin/env python3
"""Draws docs/needle-forces.svg: force against gauge for every tissue of share/bodkin/tissues.xml, measured points
drawn in. The laws of docs/needle-forces.md are written down here a second time, apart from src/forces/needle_law.cpp.
With --table it prints the numbers of the page instead. Run it in the root of the repository."""
import math
import sys
import xml.etree.ElementTree as ET

GAUGES = {14: 2.108, 15: 1.829, 16: 1.651, 17: 1.473, 18: 1.27, 19: 1.067, 20: 0.9081, 21: 0.8192, 22: 0.7176,
          23: 0.6414, 24: 0.5652, 25: 0.5144, 26: 0.4636, 27: 0.4128, 28: 0.362, 29: 0.3366, 30: 0.3112}
BEVEL = {"quincke": 20, "tuohy": 30, "chiba": 25, "diamond": 15, "whitacre": 12, "sprotte": 12, "conical": 12,
         "filiform": 8, "trephine": 20}
STRETCHED = {"whitacre", "sprotte", "conical", "filiform"}
SHOWN = {"skin": "#B5651D", "muscle": "#A6453B", "supraspinous_ligament": "#0072B2",
         "interspinous_ligament": "#56B4E9", "ligamentum_flavum": "#009E73", "dura": "#CC79A7", "disc": "#555555"}
# gauge, N, half of the bar, measured or simulated, tissue, label, its position: x and y from the point, anchor
POINTS = [(18, 5.0, 1.0, True, "ligamentum_flavum", "Naemura, 18G", 9, 10, "start"),
          (16, 9.0, 0.0, True, "ligamentum_flavum", "Brett 1997, 16G", -9, -6, "end"),
          (24, 4.7, 0.0, False, "ligamentum_flavum", "Sutherland 2013, simulated", -9, -10, "start"),
          (24, 1.5, 0.0, False, "skin", "Sutherland 2013, simulated", -9, -10, "start"),
          (22, 1.22, 0.0, True, "skin", "median of 24 studies, many needles", 0, 21, "start")]


def tip_factor(tip):
    torn = 1.22 if tip in STRETCHED else math.pi if tip == "trephine" else 1.0
    return 0.77 * torn + 0.23 * math.tan(math.radians(BEVEL[tip])) / math.tan(math.radians(20))


def tissues():
    found = {}
    for tissue in ET.parse("share/bodkin/tissues.xml").getroot().iter("tissue"):
        physical = tissue.find("physical")
        if physical is not None:
            found[tissue.get("name")] = physical.attrib
    return found


def puncture(tissue, gauge, tip):
    force = float(tissue.get("puncture_force_N", 0))
    ratio = GAUGES[gauge] / float(tissue.get("reference_diameter_mm", 0.7176))
    return (force * ratio ** float(tissue.get("exponent", 1)) * tip_factor(tip) /
            tip_factor(tissue.get("reference_tip", "quincke")))


def friction(tissue, gauge):
    return float(tissue.get("friction_MPa", 0)) * math.pi * GAUGES[gauge]


def table(library):
    needles = [(14, "tuohy"), (16, "tuohy"), (18, "tuohy"), (20, "quincke"), (22, "quincke"), (22, "whitacre"),
               (25, "quincke"), (25, "whitacre"), (27, "quincke"), (30, "filiform")]
    print("| tissue | " + " | ".join(f"{g}G {t}" for g, t in needles) + " |")
    print("|---|" + "---|" * len(needles))
    for name, tissue in library.items():
        if float(tissue.get("puncture_force_N", 0)) > 0:
            print(f"| {name.replace('_', ' ')} | " + " | ".join(f"{puncture(tissue, g, t):.2f}" for g, t in needles) +
                  " |")


def draw(library):
    width, height, left, top, inner, tall = 980, 430, 60, 40, 380, 320
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" '
           'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']

    def panel(origin, title, label, most, step, value, points, names):
        def x(gauge):
            return origin + inner * (GAUGES[gauge] - 0.28) / (2.15 - 0.28)

        def y(force):
            return top + tall * (1 - min(force, most) / most)

        out.append(f'<text x="{origin + inner / 2}" y="24" text-anchor="middle" font-size="14">{title}</text>')
        out.append(f'<rect x="{origin}" y="{top}" width="{inner}" height="{tall}" fill="none" stroke="#888"/>')
        for gauge in (14, 16, 18, 20, 22, 25, 27, 30):
            out.append(f'<line x1="{x(gauge):.1f}" x2="{x(gauge):.1f}" y1="{top}" y2="{top + tall}" stroke="#eee"/>')
            if gauge != 27:  # its label would overlap its neighbours'
                out.append(f'<text x="{x(gauge):.1f}" y="{top + tall + 16}" text-anchor="middle">{gauge}G</text>')
        count = round(most / step)
        for i in range(count + 1):
            out.append(f'<text x="{origin - 6}" y="{y(i * step) + 4:.1f}" text-anchor="end">{i * step:g}</text>')
        out.append(f'<text x="{origin + inner / 2}" y="{top + tall + 36}" text-anchor="middle">needle, by its outer '
                   'diameter</text>')
        out.append(f'<text x="{origin - 40}" y="{top + tall / 2}" text-anchor="middle" transform="rotate(-90 '
                   f'{origin - 40} {top + tall / 2})">{label}</text>')
        for row, (name, colour) in enumerate(names.items()):
            line = " ".join(f"{x(g):.1f},{y(value(library[name], g)):.1f}" for g in sorted(GAUGES, reverse=True)
                            if value(library[name], g) <= most)
            # Dashes leave the curve of another tissue visible beneath.
            style = f'stroke="{colour}" stroke-width="2.5"' + (
                ' stroke-dasharray="7 7"' if name == "interspinous_ligament" else "")
            out.append(f'<polyline points="{line}" fill="none" {style}/>')
            out.append(f'<line x1="{origin + 10}" x2="{origin + 30}" y1="{top + 14 + 16 * row}" '
                       f'y2="{top + 14 + 16 * row}" {style}/>')
            out.append(f'<text x="{origin + 36}" y="{top + 18 + 16 * row}">{name.replace("_", " ")}</text>')
        for gauge, force, half, measured, name, words, right, down, anchor in points:
            colour = names[name]
            if half:
                out.append(f'<line x1="{x(gauge):.1f}" x2="{x(gauge):.1f}" y1="{y(force - half):.1f}" '
                           f'y2="{y(force + half):.1f}" stroke="{colour}" stroke-width="2"/>')
            out.append(f'<circle cx="{x(gauge):.1f}" cy="{y(force):.1f}" r="5" stroke="{colour}" stroke-width="2" '
                       f'fill="{colour if measured else "white"}"><title>{words}: {force} N</title></circle>')
            out.append(f'<text x="{x(gauge) + right:.1f}" y="{y(force) + down:.1f}" font-size="10.5" '
                       f'text-anchor="{anchor}" fill="{colour}" stroke="white" stroke-width="3" '
                       f'paint-order="stroke">{words}</text>')

    panel(left, "force before it gives way (Tuohy to 18G, Quincke from 19G)", "N", 16, 2,
          lambda tissue, gauge: puncture(tissue, gauge, "tuohy" if gauge <= 18 else "quincke"), POINTS, SHOWN)
    liver = {"organ": "#8B5A2B"}
    rubbing = {name: colour for name, colour in SHOWN.items() if name != "disc"} | liver
    panel(left + inner + 110, "friction on each mm of sliding shaft", "N/mm", 0.24, 0.04, friction,
          [(18, 0.01196, 0.0, True, "organ", "organ: liver, Okamura 2004", 0, -58, "middle")], rubbing)
    out.append(f'<text x="{left}" y="{height - 12}" font-size="11">Filled: measured. Hollow: result of a simulation. '
               'Curves: the laws. Needles of two sizes were measured in ligamentum flavum only.</text>')
    out.append("</svg>")
    with open("docs/needle-forces.svg", "w", encoding="utf-8") as file:
        file.write("\n".join(out) + "\n")


if __name__ == "__main__":
    if "--table" in sys.argv:
        table(tissues())
    else:
        draw(tissues())

#!/usr/bin/env python3
"""Draws docs/evidence.svg: the numbers of share/bodkin/tissues.xml (physical) beside every published value that
docs/evidence.md lists, on one logarithmic axis per quantity. Run it in the root of the repository."""
import math
import xml.etree.ElementTree as ET

# quantity, tissue, attribute, factor to the unit, unit, published: (label, value or None, low, high, measured)
ROWS = [
    ("puncture force", "skin", "puncture_force_N", 1, "N", [
        ("24 studies, many needles: median, range", 1.22, 0.0005, 19.2, True),
        ("taper suture needles, abdominal skin", None, 0.48, 1.0, True),
        ("cutting suture needles, abdominal skin", None, 0.51, 0.95, True),
        ("24G, simulated", 1.5, None, None, False)]),
    ("puncture force", "muscle", "puncture_force_N", 1, "N", [("24G axial force, simulated", None, 0.5, 1.5, False),
                                                              ("12 mm of shoulder tissue", 1.0, None, None, True)]),
    ("puncture force", "ligamentum_flavum", "puncture_force_N", 1, "N", [
        ("18G, porcine, SD 1.0", 5.0, 4.0, 6.0, True), ("16G, porcine and cadavers", 9.0, None, None, True),
        ("24G, simulated", 4.7, None, None, False)]),
    ("dimpling", "dura", "dimpling_mm", 1, "mm", [("people, spinal needle", None, 2.0, 6.0, True)]),
    ("Young's modulus", "skin", "young_MPa", 1, "MPa", [("all methods, a review", None, 0.005, 140.0, True),
                                                        ("dermis, indentation", 0.035, None, None, True),
                                                        ("excised, tension", 98.97, None, None, True)]),
    ("Young's modulus", "muscle", "young_MPa", 1, "MPa", [("finite-element input", 0.03687, None, None, False),
                                                          ("indentation", 0.08, None, None, True)]),
    ("Young's modulus", "ligamentum_flavum", "young_MPa", 1, "MPa", [
        ("along the fibres, tension", None, 15.0, 19.5, True), ("needle model", 0.17, None, None, False)]),
    ("Young's modulus", "disc", "young_MPa", 1, "MPa", [("nucleus and annulus, finite-element input", None, 1.0, 4.2,
                                                         False)]),
    ("friction at 1.27 mm", "organ", "friction_MPa", math.pi * 1.27 * 1000, "N/m", [
        ("bovine liver, in and out", None, 10.57, 11.96, True)]),
]


def main():
    own = {tissue.get("name"): tissue.find("physical") for tissue in ET.parse("share/bodkin/tissues.xml").getroot()}
    left, inner, row, top = 430, 440, 18, 34
    lines = sum(1 + len(published) for *_, published in ROWS)
    height = top + row * (lines + 1) + 40
    low, high = math.log10(0.0003), math.log10(200.0)

    def x(value):
        return left + inner * (math.log10(value) - low) / (high - low)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + inner + 60}" height="{height}" '
           'font-family="sans-serif" font-size="12">', f'<rect width="{left + inner + 60}" height="{height}" '
           'fill="white"/>']
    for power in range(-3, 3):
        place = x(10.0 ** power)
        out.append(f'<line x1="{place:.1f}" x2="{place:.1f}" y1="{top - 8}" y2="{height - 36}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{place:.1f}" y="{top - 14}" text-anchor="middle">{10.0 ** power:g}</text>')
    y = top + row
    for quantity, tissue, attribute, factor, unit, published in ROWS:
        value = factor * float(own[tissue].get(attribute))
        out.append(f'<text x="10" y="{y}" font-weight="bold">{tissue.replace("_", " ")}, {quantity}, {unit}: '
                   f'{value:.3g}</text>')
        out.append(f'<rect x="{x(value) - 5:.1f}" y="{y - 9}" width="10" height="10" fill="#D55E00"/>')
        y += row
        for words, middle, lowest, highest, measured in published:
            colour = "#0072B2" if measured else "#999999"
            out.append(f'<text x="30" y="{y}">{words}{"" if measured else " (not measured)"}</text>')
            if lowest is not None:
                out.append(f'<line x1="{x(lowest):.1f}" x2="{x(highest):.1f}" y1="{y - 4}" y2="{y - 4}" '
                           f'stroke="{colour}" stroke-width="3"/>')
            if middle is not None:
                out.append(f'<circle cx="{x(middle):.1f}" cy="{y - 4}" r="5" fill="{colour}"/>')
            y += row
    out.append(f'<text x="10" y="{height - 12}" font-size="11">Squares: Bodkin. Blue: measured, grey: simulated or '
               'chosen by others. Bars: range, quartiles or one standard deviation.</text>')
    out.append("</svg>")
    with open("docs/evidence.svg", "w", encoding="utf-8") as file:
        file.write("\n".join(out) + "\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Force-depth curves with noise, from the papers' equations and independent of Bodkin's code.

    measured_by_others.py tracking_wall SEED     Alamilla 2018, eq. 3 to 7: one layer of 1.2 N, K_t 0.8 N/mm, catch-up 0.4 s
    measured_by_others.py shoulder SEED          the same through the nine layers of its section 3.4
    measured_by_others.py dahl SEED              Dahl 1968: the shaft in three layers of 0.01, 0.05 and 0.002 N/mm
    measured_by_others.py profile SEED           Kwon 2001: skin of 0.3 N/mm to 5 mm, then springs of 0.4, 0.9 and 0.2 N/mm
                                                 that trail by 2 mm
    measured_by_others.py layered GAUGE_MM SEED  Heng 2004, eq. 2 at rest: breaks at 2 N per mm of diameter, then friction

Nothing is stepped at Bodkin's tick: walls move in steps of 0.1 ms. 100 samples a second.
"""
import random
import sys


def path(legs, rate=100.0, start=-0.5):
    """Depths (mm) of legs of (speed in mm/s, duration in s)."""
    depth, time, rows = start, 0.0, []
    for speed, duration in legs:
        for _ in range(round(duration * rate)):
            rows.append((time, depth))
            time += 1.0 / rate
            depth += speed / rate
    return rows


def tracking_wall(rows, layers, stiffness, catch_up):
    """Alamilla 2018: `layers` are (from in mm, force in N). The wall in 100 steps between two samples."""
    wall, deepest, stop, free, out = 0.0, 0.0, None, False, []
    last = rows[0]
    for time, depth in rows:
        for i in range(1, 101):
            t = last[0] + (time - last[0]) * i / 100.0
            x = last[1] + (depth - last[1]) * i / 100.0
            if x <= 0.0:
                force = 0.0
                continue
            held = [f for begin, f in layers if begin <= x][-1]
            if free:
                force = 0.0
                if x <= deepest:
                    continue
                free, wall = False, deepest
            deepest = max(deepest, x)
            if depth == last[1]:
                if stop is None:
                    stop = (last[0], wall, x)
                wall = stop[1] + (stop[2] - stop[1]) * min(1.0, (t - stop[0]) / catch_up)
            else:
                stop = None
                if depth > last[1]:
                    wall = max(wall, x - held / stiffness)
            force = stiffness * max(0.0, x - wall)
            if depth < last[1] and force == 0.0:
                free = True
        last = (time, depth)
        out.append((time, depth, force))
    return out


def layered(rows, breaks_at, stiffness=0.08, friction=0.02):
    """Heng 2004, eq. 2 at rest: the elastic force grows with the square and the cube, then breaks; then friction."""
    broken, out = None, []
    for time, depth in rows:
        if depth <= 0.0:
            out.append((time, depth, 0.0))
            continue
        # k (x/3 + x^2/2 + x^3/6): elements of 1 mm, at rest
        force = stiffness * (depth / 3.0 + depth**2 / 2.0 + depth**3 / 6.0)
        if broken is None and force >= breaks_at:
            broken = depth
        out.append((time, depth, force if broken is None else friction * depth))
    return out


def held(layers, depth):
    return [value for begin, value in layers if begin <= depth][-1]


def dahl(rows, layers, per_newton=3.0):
    """Dahl 1968: a bristle of the shaft, dz/dx = 1 - sigma z sgn(dx) / Fc, in 1000 steps between two samples."""
    ends = [begin for begin, _ in layers[1:]] + [float("inf")]
    stretch, out, last = 0.0, [], rows[0]
    for time, depth in rows:
        coulomb = 0.0
        for i in range(1, 1001):
            x = last[1] + (depth - last[1]) * i / 1000.0
            dx = (depth - last[1]) / 1000.0
            coulomb = sum(f * max(0.0, min(x, end) - begin) for (begin, f), end in zip(layers, ends))
            if coulomb > 0.0:
                stretch += dx * (1.0 - per_newton * stretch * (1 if dx > 0 else -1))
        out.append((time, depth, per_newton * coulomb * stretch))
        last = (time, depth)
    return out


def profile(rows, layers, skin=0.3, puncture=5.0, trailing=2.0):
    """Kwon 2001, on the way in: the spring of the skin, then that of each layer, whose slack end trails by 2 mm. A
    firmer layer takes the force over as it is, a softer one the stretch."""
    out, force, tissue, last = [], None, None, 0.0
    for time, depth in rows:
        if depth <= 0.0:
            out.append((time, depth, 0.0))
            continue
        if force is None and depth < puncture:
            out.append((time, depth, skin * depth))
            continue
        here = held(layers, depth)
        if force is None:
            force, tissue, last = here * trailing, here, depth
        if here < tissue:
            force *= here / tissue
        tissue = here
        force = min(here * trailing, force + here * (depth - last))
        last = depth
        out.append((time, depth, force))
    return out


def main(arguments):
    kind, seed = arguments[0], int(arguments[-1])
    if kind == "tracking_wall":
        rows = path([(10.0, 1.2), (0.0, 0.6), (-15.0, 0.3), (20.0, 0.6)])
        curve, noise = tracking_wall(rows, [(0.0, 1.2)], 0.8, 0.4), 0.02
    elif kind == "shoulder":
        forces = [1.5, 1.0, 1.8, 2.0, 3.0, 3.5, 2.5, 4.0, 4.5]
        layers = [(150.0 / 9.0 * i, force) for i, force in enumerate(forces)]
        rows = path([(30.0, 3.0), (0.0, 0.8), (30.0, 1.95)])
        curve, noise = tracking_wall(rows, layers, 0.5, 0.5), 0.05
    elif kind == "dahl":
        rows = path([(10.0, 2.0), (-10.0, 0.3), (10.0, 0.8)])
        curve, noise = dahl(rows, [(0.0, 0.01), (8.0, 0.05), (15.0, 0.002)]), 0.005
    elif kind == "profile":
        rows = path([(10.0, 3.0)])
        curve, noise = profile(rows, [(0.0, 0.4), (12.0, 0.9), (20.0, 0.2)]), 0.01
    else:
        curve, noise = layered(path([(5.0, 2.4)]), 2.0 * float(arguments[1])), 0.01
    noisy = random.Random(seed)
    print("time_s,depth_mm,force_N")
    for time, depth, force in curve:
        print(f"{time:.4f},{depth:.6f},{force + noisy.gauss(0.0, noise):.6f}")


if __name__ == "__main__":
    main(sys.argv[1:])

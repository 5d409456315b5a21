#!/usr/bin/env python3
"""Force-depth curves with noise, from the papers' equations and independent of Bodkin's code.

    measured_by_others.py tracking_wall SEED     Alamilla 2018, eq. 3 to 7: one layer of 1.2 N, K_t 0.8 N/mm, catch-up 0.4 s
    measured_by_others.py shoulder SEED          the same through the nine layers of its section 3.4
    measured_by_others.py dahl SEED              Dahl 1968: the shaft in three layers of 0.01, 0.05 and 0.002 N/mm
    measured_by_others.py profile SEED           Kwon 2001: skin of 0.3 N/mm to 5 mm, then springs of 0.4, 0.9 and 0.2 N/mm
                                                 that trail by 2 mm
    measured_by_others.py heng SPEED SEED        Heng 2004, eq. 2 to 5: skin, muscle from 7 mm and a ligament from 14 mm, pushed in at
                                                 SPEED mm/s, a rest and a withdrawal
    measured_by_others.py pressed SEED           the same law, a skin of 3 mm that gives way after what lies behind it
    measured_by_others.py fat SEED               the same law, a layer between 5 and 15 mm that resists nothing
    measured_by_others.py layered GAUGE_MM SEED  Heng 2004, eq. 2 at rest: breaks at 2 N per mm of diameter, then friction

Nothing is stepped at Bodkin's tick: walls move in steps of 0.1 ms. 100 samples a second.
With the word clean in place of the seed there is no noise.
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


def cubic(stiffness, spacing, depth):
    """Eq. 2 without its damper."""
    a = depth / spacing
    return stiffness * spacing * a * (a + 1.0) * (a + 2.0) / 6.0


def cubic_inverse(stiffness, spacing, force):
    low, high = 0.0, 1000.0
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if cubic(stiffness, spacing, middle) < force else (low, middle)
    return low


class HengTissue:
    """One tissue of Heng 2004 from its near face on: it is pressed (eq. 2), breaks (eq. 3), then sticks to the shaft (eq. 4), lets
    go at 1.2 times the friction with which it slides (eq. 14, 5), and sticks again when the needle stops or turns."""

    def __init__(self, near, thickness, stiffness, breaks_at, friction, shaft_ratio=1.5, viscosity_ratio=0.02):
        self.near, self.thickness, self.stiffness = near, thickness, stiffness
        self.viscosity, self.breaks_at = viscosity_ratio * stiffness, breaks_at
        self.friction, self.shaft = friction, max(1e-6, shaft_ratio * friction)
        self.slips_at, self.kept = cubic_inverse(self.shaft, 0.5, 1.2 * friction), cubic_inverse(self.shaft, 0.5, friction)
        self.state, self.strain, self.length, self.way = "whole", 0.0, 0.0, 0

    def step(self, depth, moved, speed):
        x = depth - self.near
        if self.state == "whole":
            if x <= 0.0:
                return 0.0
            force = max(0.0, cubic(self.stiffness, 1.0, x) + x * self.viscosity * speed)
            if force < self.breaks_at or moved <= 0.0:
                return force
            self.state, self.strain, self.length = "held", 0.0, min(x, self.thickness)
            return 0.0
        if self.state == "held":
            self.strain += moved
            if abs(self.strain) < self.slips_at:
                return self.length * (1 if self.strain > 0 else -1) * cubic(self.shaft, 0.5, abs(self.strain))
            self.state, self.way = "slides", 1 if self.strain > 0 else -1
        if moved * self.way <= 0.0:
            self.state, self.strain = "held", self.way * self.kept + moved
            return self.length * (1 if self.strain > 0 else -1) * cubic(self.shaft, 0.5, abs(self.strain))
        self.length = max(0.0, min(x, self.thickness))
        return self.way * self.friction * self.length


def heng(rows, layers):
    """`layers` are (from in mm, stiffness, break force, friction); 0.1 ms steps."""
    ends = [layer[0] for layer in layers[1:]] + [float("inf")]
    tissues = [HengTissue(near, end - near, k, h, d) for (near, k, h, d), end in zip(layers, ends)]
    out, last, speed = [], rows[0], (rows[1][1] - rows[0][1]) / (rows[1][0] - rows[0][0])
    for time, depth in rows:
        force, moved = 0.0, (depth - last[1]) / 100.0
        if time > last[0]:
            speed = (depth - last[1]) / (time - last[0])
        for i in range(1, 101):
            force = sum(tissue.step(last[1] + i * moved, moved, speed) for tissue in tissues)
        last = (time, depth)
        out.append((time, depth, force))
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
    kind, seed = arguments[0], arguments[-1]
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
    elif kind == "heng":
        speed = float(arguments[1])
        rows = path([(speed, 24.0 / speed), (0.0, 0.2), (-speed, 4.0 / speed)])
        curve, noise = heng(rows, [(0.0, 0.05, 1.1, 0.02), (7.0, 0.03, 0.6, 0.01), (14.0, 0.12, 2.0, 0.05)]), 0.01
    elif kind == "pressed":
        curve, noise = heng(path([(10.0, 1.6)]), [(0.0, 0.01, 0.9, 0.02), (3.0, 0.06, 0.7, 0.01)]), 0.01
    elif kind == "fat":
        layers = [(0.0, 0.05, 1.1, 0.02), (5.0, 1e-9, 1e-9, 1e-6), (15.0, 0.12, 2.0, 0.05)]
        curve, noise = heng(path([(10.0, 2.6)]), layers), 0.01
    else:
        curve, noise = layered(path([(5.0, 2.4)]), 2.0 * float(arguments[1])), 0.01
    noisy = random.Random(0 if seed == "clean" else int(seed))
    if seed == "clean":
        noise = 0.0
    print("time_s,depth_mm,force_N")
    for time, depth, force in curve:
        print(f"{time:.4f},{depth:.6f},{force + noisy.gauss(0.0, noise):.6f}")


if __name__ == "__main__":
    main(sys.argv[1:])

"""Pushes a needle 60 mm along the planned path of a case and draws it out again: python3 insertion.py CASE

Prints what is met on the way, and the greatest force in each tissue.
"""
import sys

import numpy

import bodkin

case = bodkin.load_case(sys.argv[1])
entry, target = case.path
axis = (target - entry) / numpy.linalg.norm(target - entry)
tick = bodkin.HapticTick(case)

speed = 10.0  # mm/s
depth = numpy.concatenate([numpy.arange(-5.0, 60.0, speed * tick.dt), numpy.arange(60.0, -5.0, -speed * tick.dt)])
poses = numpy.array([bodkin.needle_pose(entry + each * axis, axis) for each in depth])
result = tick.run(poses)

for event in result["events"]:
    print(f"{event['tick'] * tick.dt:6.2f} s {event['depth']:6.1f} mm  {event['event']:<20} {event['tissue']}")
for number in numpy.unique(result["tissue"]):
    force = result["resistance"][result["tissue"] == number]
    print(f"{case.tissue(int(number)):<24} {force.min():6.2f} to {force.max():5.2f} N")

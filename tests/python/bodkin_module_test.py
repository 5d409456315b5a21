"""The Python module: bodkin_module_test.py BODKIN FOLDER_OF_MODULE, with the bodkin command for patients."""
import os
import subprocess
import sys
import tempfile
import unittest

command, module_folder, example = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
sys.path.insert(0, module_folder)

import numpy  # noqa: E402

import bodkin  # noqa: E402

folder = tempfile.TemporaryDirectory()
patient = os.path.join(folder.name, "patient")


def insertion(case, deepest, step):
    entry, target = case.path
    axis = (target - entry) / numpy.linalg.norm(target - entry)
    return [bodkin.needle_pose(entry + depth * axis, axis) for depth in numpy.arange(-5.0, deepest, step)]


class Module(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([command, "-q", "case", "synthesize", "lumbar", patient, "--spacing", "2"], check=True,
                       stdout=subprocess.DEVNULL)

    def test_a_case_tells_what_it_is(self):
        case = bodkin.load_case(patient)
        self.assertEqual(case.rate, 1000.0)
        self.assertEqual(case.needle_length, 90.0)
        self.assertGreater(numpy.linalg.norm(case.path[1] - case.path[0]), 30.0)
        self.assertEqual(case.tissue(1), "skin")

    def test_a_needle_meets_the_layers_in_their_order_and_pushes_the_hand_out(self):
        case = bodkin.load_case(patient)
        tick = bodkin.HapticTick(case)
        self.assertEqual(tick.dt, 0.001)
        entry, target = case.path
        axis = (target - entry) / numpy.linalg.norm(target - entry)
        met = []
        greatest = 0.0
        for pose in insertion(case, 55.0, 0.02):
            result = tick.step(pose)
            if result["depth"] <= 0.0:
                self.assertEqual(numpy.linalg.norm(result["force"]), 0.0)
            greatest = max(greatest, -float(result["force"] @ axis))
            met += [event["tissue"] for event in result["events"] if event["event"] == "tissue_entered"]
        self.assertGreater(greatest, 1.0)
        order = [met.index(each) for each in ("fat", "interspinous ligament", "ligamentum flavum", "epidural space")]
        self.assertEqual(order, sorted(order))

    def test_many_ticks_are_the_same_to_the_bit_as_one_by_one_and_after_a_reset(self):
        case = bodkin.load_case(patient)
        poses = insertion(case, 30.0, 0.05)
        one_by_one = bodkin.HapticTick(case)
        expected = numpy.array([one_by_one.step(pose)["force"] for pose in poses])
        tick = bodkin.HapticTick(case)
        for _ in range(2):
            result = tick.run(numpy.array(poses))
            self.assertTrue((result["force"] == expected).all())
            tick.reset()

    def test_another_model_feels_different(self):
        first = bodkin.HapticTick(bodkin.load_case(patient))
        case = bodkin.load_case(patient, resistance="depth_profile", constraint="none")
        second = bodkin.HapticTick(case)
        poses = numpy.array(insertion(case, 20.0, 0.05))
        self.assertFalse((first.run(poses)["resistance"] == second.run(poses)["resistance"]).all())

    def test_what_is_wrong_is_one_sentence(self):
        for wrong in (lambda: bodkin.load_case("/nowhere"), lambda: bodkin.load_case(patient, resistance="magic"),
                      lambda: bodkin.needle_pose([0, 0, 0], [0, 0, 0]),
                      lambda: bodkin.HapticTick(bodkin.load_case(patient)).step(numpy.zeros((4, 4))),
                      lambda: bodkin.HapticTick(bodkin.load_case(patient)).run(numpy.zeros((4, 4)))):
            with self.assertRaises(bodkin.InputError) as caught:
                wrong()
            self.assertNotIn("\n", str(caught.exception))

    def test_the_example_runs(self):
        said = subprocess.run([sys.executable, example, patient], check=True, capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": module_folder}).stdout
        self.assertIn("ligamentum flavum", said)
        self.assertIn("contact", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)

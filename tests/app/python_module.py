"""The module for Python, beside the command line: the same scene comes to the same bits. KNEAD_PROGRAM and EXAMPLES say where things are."""

import gc
import inspect
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
import unittest

import numpy

import knead

EXAMPLES = pathlib.Path(os.environ["EXAMPLES"])
PROGRAM = os.environ["KNEAD_PROGRAM"]
LUMP = EXAMPLES / "lump.step"
SPACING = 0.005
SECONDS = 0.2

RECIPE = {
    "version": 1,
    "part": {"file": str(LUMP)},
    "spacing_mm": 5,
    "material": {"preset": "modeling-clay", "poisson_ratio": 0.4},
    "manipulators": [
        {
            "name": "ball",
            "kind": "ball",
            "size_mm": 24,
            "position_mm": [20, 20, 36.5],
            "keyframes": [{"time_s": 0.4, "position_mm": [20, 20, 26]}],
        }
    ],
    "fixtures": [{"name": "foot", "box_mm": [-1, -1, -1, 200, 200, 1]}],
    "gravity_m_s2": [0, 0, -9.81],
    "floor": {"height_mm": 0, "friction": 0.8},
    "duration_s": SECONDS,
}


def clay():
    part = knead.read(LUMP).parts[0]
    return knead.fill(part, spacing=SPACING, material=knead.Material("modeling-clay", poisson_ratio=0.4))


FILLING = clay()


def scene():
    """The recipe, said in Python, and its ball."""
    simulation = knead.Simulation([FILLING], gravity=(0, 0, -9.81), floor=0, floor_friction=0.8)
    simulation.fix(box=((-0.001, -0.001, -0.001), (0.2, 0.2, 0.001)), name="foot")
    ball = simulation.add_tool("ball", 0.024, (0.02, 0.02, 0.0365), keyframes=[(0.4, (0.02, 0.02, 0.026))])
    return simulation, ball


def address(array):
    return array.__array_interface__["data"][0]


class TheModule(unittest.TestCase):
    def test_a_part_has_what_its_file_says(self):
        model = knead.read(LUMP)
        self.assertEqual(model.unit, "mm")
        part = model.parts[0]
        self.assertTrue(part.is_closed)
        corners = part.vertices[part.triangles]
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        volume = (corners[:, 0] * normals).sum() / 6
        self.assertAlmostEqual(volume / part.volume, 1, delta=0.01)
        self.assertLess(part.face_of_triangle.max(), part.faces)
        numpy.testing.assert_allclose(part.vertices.min(axis=0), part.box[0], atol=1e-4)

    def test_arrays_keep_what_they_show(self):
        vertices = knead.read(LUMP).parts[0].vertices
        before = vertices.copy()
        gc.collect()
        numpy.testing.assert_array_equal(vertices, before)

    def test_a_filling_holds_the_volume_of_its_part(self):
        self.assertAlmostEqual(FILLING.volumes.sum() / FILLING.part.volume, 1, delta=0.01)
        self.assertEqual(FILLING.rest.shape, (len(FILLING), 3))
        self.assertEqual(FILLING.spacing, SPACING)
        coarse = knead.fill(FILLING.part, objects=300)
        self.assertLess(abs(len(coarse) / 300 - 1), 0.3)
        self.assertEqual(coarse.material, knead.Material())

    def test_script_recipe_and_command_line_come_to_the_same_bits(self):
        simulation, ball = scene()
        simulation.run(SECONDS)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "press.recipe.json"
            path.write_text(json.dumps(RECIPE))
            printed = subprocess.run([PROGRAM, "run", path, "--out", folder, "--json"], capture_output=True, check=True)
            line = json.loads(printed.stdout)
            report = knead.run(RECIPE, folder)
        self.assertEqual(simulation.state_hash, line["state_hash"])
        self.assertEqual(report["state_hash"], line["state_hash"])
        self.assertEqual(simulation.steps, line["steps"])
        moved = simulation.bodies[0].displacements
        self.assertGreater(moved[:, 2].min(), -0.0106)
        self.assertLess(moved[:, 2].min(), -0.001)
        self.assertGreater(ball.force[2], 0)

    def test_looking_on_the_way_changes_nothing(self):
        simulation, ball = scene()
        plain, _ = scene()
        looks = []

        def look(running):
            looks.append((running.time, ball.force[2], running.bodies[0].von_mises.max()))

        simulation.run(0.1, look, every=0.02)
        plain.run(0.1)
        self.assertEqual(len(looks), 5)
        self.assertEqual(simulation.state_hash, plain.state_hash)
        ended, _ = scene()
        ended.run(10, lambda running: running.time < 0.03)
        self.assertLess(ended.time, 0.1)

    def test_arrays_are_the_memory_of_the_simulation(self):
        simulation, _ = scene()
        simulation.run(0.05)
        body = simulation.bodies[0]
        for name in ("positions", "displacements", "strains", "stresses", "von_mises"):
            first, second = getattr(body, name), getattr(body, name)
            self.assertEqual(address(first), address(second), name)
            self.assertFalse(first.flags.owndata, name)
            with self.assertRaises(ValueError):
                first[0] = 0
        numpy.testing.assert_allclose(body.positions - body.displacements, FILLING.rest, atol=1e-15)
        stresses = body.stresses
        self.assertEqual(stresses.shape, (len(FILLING), 3, 3))
        numpy.testing.assert_allclose(stresses, stresses.transpose(0, 2, 1), atol=1e-6 * abs(stresses).max())
        deviator = stresses - numpy.trace(stresses, axis1=1, axis2=2)[:, None, None] / 3 * numpy.eye(3)
        numpy.testing.assert_allclose(body.von_mises, numpy.sqrt(1.5 * (deviator**2).sum(axis=(1, 2))), rtol=1e-9, atol=1e-6)
        before, kept = body.positions, body.positions.copy()
        simulation.step(3)
        self.assertNotEqual(address(body.positions), address(before))
        del simulation, body
        gc.collect()
        numpy.testing.assert_array_equal(before, kept)

    def test_ctrl_c_stops_and_the_simulation_goes_on(self):
        simulation, _ = scene()

        def interrupt():
            while simulation.steps < 3:
                pass
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        with self.assertRaises(KeyboardInterrupt):
            thread.start()
            simulation.run(3600)
        thread.join()
        before = simulation.steps
        simulation.step(2)
        self.assertEqual(simulation.steps, before + 2)
        plain, _ = scene()
        plain.step(simulation.steps)
        self.assertEqual(simulation.state_hash, plain.state_hash)

    def test_ctrl_c_stops_a_recipe(self):
        def interrupt(share, stage):
            if stage.startswith("simulating"):
                os.kill(os.getpid(), signal.SIGINT)

        with tempfile.TemporaryDirectory() as folder, self.assertRaises(KeyboardInterrupt):
            knead.run(RECIPE, folder, settings={"duration_s": 3600}, progress=interrupt)

    def test_from_within_its_own_computation_nothing_goes_on(self):
        simulation, _ = scene()
        looks = threading.Event()

        def look():
            looks.set()
            simulation.time

        other = threading.Thread(target=look)
        refused = []

        def go_on(share, stage):
            if refused:
                return
            other.start()
            looks.wait()
            for _ in range(1000):
                try:
                    simulation.step()
                except knead.Error as error:
                    refused.append(str(error))

        with tempfile.TemporaryDirectory() as folder:
            simulation.export(os.path.join(folder, "lump.step"), progress=go_on)
        other.join()
        self.assertEqual(len(refused), 1000)
        self.assertIn("in the midst of computing", refused[0])
        self.assertEqual(simulation.steps, 0)

    def test_progress_is_told_and_its_errors_arrive(self):
        told = []
        knead.read(LUMP, progress=lambda share, stage: told.append((share, stage)))
        self.assertTrue(told)
        self.assertTrue(all(0 <= share <= 1 and isinstance(stage, str) for share, stage in told))

        def fail(share, stage):
            raise ZeroDivisionError(stage)

        with self.assertRaises(ZeroDivisionError):
            knead.read(LUMP, progress=fail)

    def test_moments_are_gone_back_to(self):
        simulation, ball = scene()
        simulation.step(5)
        moment = simulation.keep()
        simulation.step(5)
        ahead = simulation.state_hash
        simulation.go_to(moment)
        self.assertEqual(simulation.steps, 5)
        simulation.step(5)
        self.assertEqual(simulation.state_hash, ahead)
        self.assertLess(moment.time, simulation.time)
        twin, _ = scene()
        with self.assertRaisesRegex(knead.Error, "of another simulation"):
            twin.go_to(moment)
        ball.remove()
        with self.assertRaisesRegex(knead.Error, "no longer"):
            ball.position
        simulation.reset()
        self.assertEqual(simulation.time, 0)

    def test_tools_and_grips_are_moved_on_the_way(self):
        filling = knead.fill(FILLING.part, spacing=SPACING, material=knead.Material("silicone-rubber"))
        simulation = knead.Simulation([filling])
        low, high = FILLING.part.box
        simulation.fix(box=(low - 0.001, (high[0], high[1], low[2] + 0.001)))
        grip = simulation.fix(box=((low[0], low[1], high[2] - 0.001), high + 0.001), velocity=(0, 0, 0.05))
        simulation.run(0.05)
        self.assertLess(grip.force[2], 0)
        self.assertAlmostEqual(simulation.bodies[0].displacements[:, 2].max(), 0.0025, delta=0.0002)
        grip.release()
        block = simulation.add_tool("box", (0.02, 0.02, 0.02), high + 0.03)
        block.drive((0, 0, -0.1))
        simulation.run(0.02)
        self.assertAlmostEqual(block.position[2], high[2] + 0.028, delta=0.0005)
        self.assertEqual(list(block.force), [0, 0, 0])
        turned = knead.rotation((0, 0, 1), numpy.pi)
        numpy.testing.assert_allclose(turned, (0, 0, 0, 1), atol=1e-15)

    def test_commands_as_projects_keep_them_do_what_methods_do(self):
        def said(simulation, tool):
            tool.place((0.03, 0.03, 0.05))
            tool.reshape("cylinder", (0.02, 0.03), friction=0.1, force_limit=20)
            tool.rename("roller")
            simulation.set_floor(None)
            simulation.set_body_kind("rigid")
            simulation.set_body_kind("deformable")
            simulation.renormalize()
            simulation.set_integrator("implicit-euler")
            simulation.set_pace("rough")
            simulation.cut((0.03, 0, 0), (1, 0, 0.1))

        def kept(simulation, _):
            words = dict(tool=0, friction=0.1, speed_limit_m_s=0.5, force_limit_n=20, size_m=[0.02, 0.02, 0.03], kind="cylinder")
            pose = {"position_m": [0.03, 0.03, 0.05], "rotation_wxyz": [1, 0, 0, 0]}
            for command, fields in [
                ("place-manipulator", {"tool": 0, "pose": pose}),
                ("reshape-manipulator", words),
                ("rename-manipulator", {"tool": 0, "name": "roller"}),
                ("set-floor", {"friction": 0.4}),
                ("set-body-kind", {"body": 0, "kind": "rigid"}),
                ("set-body-kind", {"body": 0, "kind": "deformable"}),
                ("renormalize", {"body": 0, "objects": [], "duration_s": 0}),
                ("set-integrator", {"integrator": "implicit-euler"}),
                ("set-pace", {"pace": "rough"}),
                ("cut", {"body": 0, "point_m": [0.03, 0, 0], "normal": [1, 0, 0.1]}),
            ]:
                self.assertIsNone(simulation.carry_out({"command": command, **fields}))

        hashes = []
        for change in (said, kept):
            simulation, tool = scene()
            simulation.step_to(20)
            simulation.keep()
            change(simulation, tool)
            simulation.step_to(simulation.steps + 2)
            self.assertEqual(tool.name, "roller")
            hashes.append(simulation.state_hash)
        self.assertEqual(*hashes)
        with self.assertRaisesRegex(knead.Error, "Step 7 cannot be gone on to: the simulation is at step 22"):
            simulation.step_to(7)
        with self.assertRaisesRegex(knead.Error, "carry_out"):
            simulation.carry_out({"command": "set-gravity"})

    def test_what_is_added_as_projects_keep_it_can_be_used(self):
        simulation, ball = scene()
        fixture = {"name": "more", "body": 0, "objects": [[0, 9]], "velocity_m_s": [0, 0, 0]}
        more = simulation.carry_out({"command": "add-fixture", "fixture": fixture})
        self.assertIsInstance(more, knead.Fixture)
        other, _ = scene()
        other.fix(objects=range(10), name="more")
        for each in (simulation, other):
            each.step(20)
        self.assertEqual(simulation.state_hash, other.state_hash)
        more.move((0, 0, 0.01), (0, 0, 0), (0, 0, 1), 0.1)
        simulation.step(5)
        with self.assertRaisesRegex(knead.Error, "has no object 1000000"):
            simulation.fix(objects=[1000000])
        with self.assertRaisesRegex(knead.Error, 'no choice "soft" here; there are: deformable'):
            simulation.set_body_kind("soft")

    def test_what_was_pressed_leaves_as_smooth_step(self):
        simulation, _ = scene()
        simulation.run(SECONDS)
        with tempfile.TemporaryDirectory() as folder:
            report = simulation.export(pathlib.Path(folder) / "pressed.step")
            back = knead.read(report["file"]).parts[0]
            simulation.export(os.path.join(folder, "pressed.stl"))
            mesh = knead.read(os.path.join(folder, "pressed.stl")).parts[0]
        self.assertEqual(back.faces, FILLING.part.faces)
        self.assertTrue(back.is_closed)
        self.assertAlmostEqual(mesh.volume / back.volume, 1, delta=0.01)
        vertices, triangles = simulation.bodies[0].surface()
        self.assertLess(triangles.max(), len(vertices))
        self.assertLess(vertices[:, 2].min(), 0.001)

    def test_parts_are_bent_by_number(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "bent.step")
            report = knead.morph(EXAMPLES / "bar.step", knead.bend(90 * (numpy.pi / 180), axis=(1, 0, 0)), out)
            printed = subprocess.run(
                [PROGRAM, "morph", EXAMPLES / "bar.step", "--bend", "90", "--axis", "x", "--output", out, "--json"],
                capture_output=True,
                check=True,
            )
        line = json.loads(printed.stdout)
        self.assertTrue(report["sound"])
        self.assertEqual(report["deformations"], line["deformations"])
        self.assertEqual(report["parts"], line["parts"])

    def test_physics_finds_the_shape_between_grips(self):
        with tempfile.TemporaryDirectory() as folder:
            out = os.path.join(folder, "drawn.step")
            grips = knead.stretch(1.3, axis=(1, 0, 0), start=0.06, end=0.1)
            how = {"material": "modeling-clay", "duration": 0.2, "objects": 300}
            report = knead.morph_by_physics(EXAMPLES / "bar.step", grips, out, **how)
            drawn = knead.read(out).parts[0]
            with self.assertRaisesRegex(knead.Error, "no material \"cheese\""):
                knead.morph_by_physics(EXAMPLES / "bar.step", grips, out, material="cheese")
            with self.assertRaisesRegex(knead.Error, "do it exactly"):
                knead.morph_by_physics(EXAMPLES / "bar.step", knead.taper(2), out, **how)
            bar = knead.read(EXAMPLES / "bar.step").parts[0]
        self.assertTrue(report["exports"][0]["sound"])
        self.assertEqual(drawn.faces, bar.faces)
        self.assertAlmostEqual(drawn.volume / bar.volume, 1, delta=0.01)

    def test_errors_are_sentences(self):
        with self.assertRaisesRegex(knead.Error, "nowhere.step"):
            knead.read("nowhere.step")
        with self.assertRaisesRegex(knead.Error, "no material \"gold\""):
            knead.Material("gold")
        with self.assertRaisesRegex(knead.Error, "Young's modulus"):
            knead.Material(youngs_modulus_pa=-1)
        with self.assertRaises(TypeError):
            knead.Material(weight=1)
        with self.assertRaises(TypeError):
            knead.fill(FILLING.part, spacing=1e-3, objects=100)
        with self.assertRaises(knead.Error):
            knead.fill(FILLING.part, spacing=1.0)
        for none in ([], [None], [FILLING, None]):
            with self.assertRaisesRegex(knead.Error, "needs a body"):
                knead.Simulation(none)
        for of_nothing in (knead.Model.parts.fget, knead.Simulation.bodies.fget, knead.Simulation.keep, knead.Simulation.reset):
            with self.assertRaises(TypeError):
                of_nothing(None)
        with self.assertRaises(TypeError):
            knead.Simulation.run(None, 1)
        simulation, _ = scene()
        with self.assertRaisesRegex(knead.Error, "holds nothing"):
            simulation.fix(box=((1, 1, 1), (2, 2, 2)))
        with self.assertRaisesRegex(knead.Error, "size of a tool"):
            simulation.add_tool("ball", (1, 2, 3), (0, 0, 0))
        with self.assertRaisesRegex(knead.Error, "knead.rotation"):
            simulation.add_tool("ball", 0.01, (0, 0, 1), rotation=(0, 0, 0, 0))
        with self.assertRaisesRegex(knead.Error, "duration_s"):
            knead.run({**RECIPE, "duration_s": -1})

    def test_what_is_wrong_before_the_first_step_changes_nothing(self):
        simulation, ball = scene()
        fixture = {"name": "far", "body": 9, "objects": [0], "velocity_m_s": [0, 0, 0]}
        amount = {"force_n": [0, 0, 1], "moment_nm": [0, 0, 0], "pressure_pa": 0}
        load = {"name": "far", "body": 9, "faces": [], "box_m": [], "objects": [], "carried": [], "amount": amount, "ramp_s": 0}
        for command, words in (
            ({"command": "add-fixture", "fixture": fixture}, "body that does not exist"),
            ({"command": "add-fixture", "fixture": {**fixture, "body": 0, "velocity_m_s": [1e9, 0, 0]}}, "faster"),
            ({"command": "add-load", "load": load}, "body that does not exist"),
            ({"command": "add-load", "load": {**load, "body": 0}}, "acts on nothing"),
        ):
            with self.assertRaisesRegex(knead.Error, words):
                simulation.carry_out(command)
        plain, _ = scene()
        plain.step(2)
        simulation.step(2)
        self.assertEqual(simulation.state_hash, plain.state_hash)

    def test_objects_named_twice_are_held_once(self):
        twice, once = knead.Simulation([FILLING]), knead.Simulation([FILLING])
        grips = twice.fix(objects=[7, 0, 0, 7, 0]), once.fix(objects=[0, 7])
        for simulation in (twice, once):
            simulation.step()
        numpy.testing.assert_array_equal(grips[0].center, grips[1].center)
        self.assertEqual(twice.state_hash, once.state_hash)

    def test_names_of_files_may_be_any_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.fsencode(folder) + b"/f\xfcnf.step"
            with self.assertRaisesRegex(knead.Error, "f\ufffdnf.step"):
                knead.read(path)
            with open(path, "wb") as file:
                file.write(LUMP.read_bytes())
            model = knead.read(path)
            self.assertEqual(os.fsencode(model.file), path)
            self.assertIn("f\ufffdnf.step", repr(model))

    def test_stub_and_module_have_the_same(self):
        stub = (pathlib.Path(knead.__file__).parent / "__init__.pyi").read_text()
        functions = {name for name, thing in vars(knead._knead).items() if callable(thing) and not inspect.isclass(thing)}
        self.assertLessEqual(functions, set(dir(knead)))
        for name in knead.__all__:
            thing = getattr(knead, name)
            self.assertRegex(stub, rf"(class|def) {name}\b")
            self.assertTrue(inspect.getdoc(thing), name)
            if inspect.isclass(thing) and name != "Error":
                body = stub.split(f"class {name}", 1)[1].split("\nclass ", 1)[0].split("\ndef ", 1)[0]
                for member in vars(thing):
                    if not member.startswith("_"):
                        self.assertRegex(body, rf"\b{member}\b", f"{name}.{member}")

    def test_every_cell_of_the_notebook_runs(self):
        notebook = json.loads((EXAMPLES / "python" / "press.ipynb").read_text())
        before = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                names = {"__name__": "__main__"}
                for cell in notebook["cells"]:
                    if cell["cell_type"] == "code":
                        exec("".join(cell["source"]), names)
            finally:
                os.chdir(before)
            self.assertTrue(os.path.exists(os.path.join(folder, "pressed.step")))


if __name__ == "__main__":
    unittest.main()

# Run by freecadcmd: a part made in FreeCAD goes to Knead, is pressed there, and comes back. KNEAD_PROGRAM, KNEAD_ADDON: what is tried.
import os
import shutil
import subprocess
import sys
import tempfile
import traceback

HOME = tempfile.mkdtemp()
status = 1
sys.path.insert(0, os.environ["KNEAD_ADDON"])
import FreeCAD
import knead_exchange as exchange
import Part


def refusal(work, *arguments):
    try:
        work(*arguments)
    except exchange.KneadError as error:
        return str(error)
    return ""


def document_with_a_part():
    document = FreeCAD.newDocument("Work")
    document.saveAs(os.path.join(HOME, "work.FCStd"))
    box = Part.makeBox(60, 30, 20)
    vertical = [edge for edge in box.Edges if abs(edge.BoundBox.ZLength - 20) < 1e-6]
    part = document.addObject("Part::Feature", "Lump")
    part.Label = "Lump of rubber"
    part.Shape = box.makeFillet(4, vertical)
    group = document.addObject("App::Part", "Assembly")
    group.Placement.Base = FreeCAD.Vector(0, 0, 500)
    group.addObject(part)
    document.recompute()
    return document, part, group


def knead(*arguments):
    done = subprocess.run([os.environ["KNEAD_PROGRAM"], *arguments], cwd=HOME, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def press(sent, result):
    recipe = os.path.join(HOME, "press.recipe.json")
    knead("recipe", sent, "--output", recipe)
    knead("run", recipe, "--out", HOME, "--set", "objects=800")
    made = [name for name in os.listdir(HOME) if name.endswith("-pressed.step")]
    assert len(made) == 1, made
    os.rename(os.path.join(HOME, made[0]), result)


def a_part_goes_and_comes_back():
    document, part, group = document_with_a_part()
    assert "export the part in Knead" in refusal(exchange.take_back, document)
    sent = exchange.send([part])
    assert sent == os.path.join(HOME, "work-knead", "Lump of rubber.step"), sent
    assert exchange.results(document) == []
    press(sent, os.path.join(HOME, "work-knead", "Lump of rubber-pressed.step"))
    assert len(exchange.results(document)) == 1

    back = exchange.take_back(document)
    assert len(back) == 1, [one.Label for one in back]
    shape = back[0].Shape
    assert back[0].Label.startswith("Lump of rubber"), back[0].Label
    assert len(shape.Solids) == 1 and shape.isValid()
    assert len(shape.Faces) == len(part.Shape.Faces)
    change = shape.Volume / part.Shape.Volume - 1
    assert 1e-6 < abs(change) < 0.05, change
    assert not part.Visibility
    assert back[0].getParentGeoFeatureGroup() == group # it lies where the part lies
    assert abs(shape.BoundBox.Center.z - part.Shape.BoundBox.Center.z) < 5

    again = exchange.take_back(document, original=exchange.ORIGINAL_REMOVED)
    assert len(again) == 1 and document.getObject("Lump") is None


def a_step_of_a_body_stands_for_the_body():
    document = FreeCAD.newDocument("Body")
    body = document.addObject("PartDesign::Body", "Body")
    step = document.addObject("PartDesign::AdditiveBox", "Step")
    body.addObject(step)
    document.recompute()
    assert exchange.bodies_of([step, body]) == [body]
    sent = exchange.send([step])
    assert sent.startswith(document.TransientDir) and os.path.getsize(sent) > 1000


def what_a_body_is_based_on_goes_as_it_is():
    document = FreeCAD.newDocument("Base")
    box = document.addObject("Part::Box", "Box")
    body = document.addObject("PartDesign::Body", "Body")
    body.BaseFeature = box
    document.recompute()
    assert exchange.bodies_of([box]) == [box]
    assert exchange.bodies_of([body.Group[0]]) == [body]


def names_are_cut_and_folders_in_the_way_are_said():
    document = FreeCAD.newDocument("Names")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    for letter in ("n", "\u540d"):
        box.Label = 300 * letter
        sent = exchange.send([box])
        assert 20 < len(os.path.basename(sent)) < 90 and os.path.getsize(sent) > 1000, sent
        assert letter in os.path.basename(sent)
    record = os.path.join(exchange.folder_of(document), ".sent.json")
    os.remove(record)
    os.mkdir(record)
    assert "could not write" in refusal(exchange.send, [box])


def what_fails_is_said():
    document = FreeCAD.newDocument("Nothing")
    empty = document.addObject("App::Part", "Empty")
    assert refusal(exchange.send, [empty]) == "Nothing solid is selected; select a body, then send it."
    exchange.preferences().SetString("Program", "/nowhere/knead")
    assert refusal(exchange.find_program).startswith("/nowhere/knead is not there")
    exchange.preferences().SetString("Program", os.environ["KNEAD_PROGRAM"])
    assert exchange.find_program() == os.environ["KNEAD_PROGRAM"]
    exchange.preferences().RemString("Program")
    os.environ["PATH"] = "/nowhere"
    assert "install Knead" in refusal(exchange.find_program)
    before = document.Objects
    broken = os.path.join(exchange.folder_of(document), "broken.step")
    with open(broken, "w") as file:
        file.write("ISO-10303-21;")
    assert refusal(exchange.take_back, document).startswith(broken)
    assert document.Objects == before


try:
    for test in (a_part_goes_and_comes_back, a_step_of_a_body_stands_for_the_body, what_a_body_is_based_on_goes_as_it_is,
                 names_are_cut_and_folders_in_the_way_are_said, what_fails_is_said):
        test()
        print("ok:", test.__name__, flush=True)
    status = 0
except BaseException:
    traceback.print_exc()
shutil.rmtree(HOME)
sys.stderr.flush()
os._exit(status) # freecadcmd would ask for more

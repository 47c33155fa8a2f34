"""Parts as lumps of real material: read, fill, press, look, and write as smooth STEP.

    import knead

    part = knead.read("lump.step").parts[0]
    clay = knead.fill(part, spacing=0.003, material=knead.Material("modeling-clay"))
    sim = knead.Simulation([clay], floor=0.0, gravity=(0, 0, -9.81))
    ball = sim.add_tool("ball", 0.024, (0.02, 0.02, 0.0365), velocity=(0, 0, -0.02))
    sim.run(0.4)
    print(ball.force, sim.bodies[0].displacements.max())
    sim.export("pressed.step")

All numbers are SI units: metres, seconds, newtons, pascals, radians. What goes wrong raises `Error`, whose text says what to do.
Ctrl+C stops what computes; a simulation may go on afterwards. Arrays of NumPy are views of the memory of Knead, which they keep
alive; they are read-only, and stay as they are while a simulation goes on.
"""

import math as _math

from ._knead import (
    Body,
    Error,
    FieldDeformation,
    Filling,
    Fixture,
    Material,
    Model,
    Moment,
    NumberDeformation,
    Part,
    Simulation,
    Tool,
    ToolPart,
    __version__,
    bend,
    example,
    field,
    fill,
    morph,
    morph_by_physics,
    read,
    run,
    scale,
    shear,
    stretch,
    taper,
    tool_parts,
    twist,
)

__all__ = [
    "Body",
    "Error",
    "FieldDeformation",
    "Filling",
    "Fixture",
    "Material",
    "Model",
    "Moment",
    "NumberDeformation",
    "Part",
    "Simulation",
    "Tool",
    "ToolPart",
    "bend",
    "example",
    "field",
    "fill",
    "morph",
    "morph_by_physics",
    "read",
    "rotation",
    "run",
    "scale",
    "shear",
    "stretch",
    "taper",
    "tool_parts",
    "twist",
]


def rotation(axis, angle):
    """The quaternion (w, x, y, z) that turns about an axis by an angle [rad], as the right hand turns."""
    x, y, z = (float(number) for number in axis)
    length = _math.sqrt(x * x + y * y + z * z)
    if length == 0:
        raise ValueError("an axis has a direction")
    half = _math.sin(angle / 2) / length
    return (_math.cos(angle / 2), half * x, half * y, half * z)


for _thing in (Body, Filling, Fixture, Material, Model, Moment, NumberDeformation, FieldDeformation, Part, Simulation, Tool, ToolPart):
    _thing.__module__ = __name__
del _thing

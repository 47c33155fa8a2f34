"""Presses a ball into a lump of clay, draws the force over the depth as a table, and writes the dent as STEP: python3 press_clay.py"""

import knead


def main():
    part = knead.read(knead.example("lump.step")).parts[0]
    clay = knead.fill(part, spacing=0.004, material=knead.Material("modeling-clay"))
    print(f"{part.name}: {part.volume * 1e6:.1f} cm3, {len(clay)} objects")

    simulation = knead.Simulation([clay], floor=0.0, floor_friction=0.8, gravity=(0, 0, -9.81))
    top = part.box[1][2]
    ball = simulation.add_tool("ball", 0.024, (0.02, 0.02, top + 0.0125), velocity=(0, 0, -0.03))

    print(f"{'depth [mm]':>10}{'force [N]':>12}")

    def look(running):
        depth = top - (ball.position[2] - 0.012)
        print(f"{depth * 1e3:10.2f}{ball.force[2]:12.2f}")

    simulation.run(0.2, look, every=0.02)
    ball.drive((0, 0, 0.1))
    simulation.run(0.1)
    print(f"the dent is {-simulation.bodies[0].displacements[:, 2].min() * 1e3:.2f} mm deep")

    report = simulation.export("dented.step")
    print(f"wrote {report['file']}")


if __name__ == "__main__":
    main()

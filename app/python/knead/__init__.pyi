import os
from typing import Any, Callable, Literal, Optional, Sequence, Union

import numpy
import numpy.typing

Floats = numpy.typing.NDArray[numpy.float64]
Integers = numpy.typing.NDArray[numpy.uint32]
Path = Union[str, os.PathLike[str]]
Vector = Union[Sequence[float], Floats]
Quaternion = tuple[float, float, float, float]
Progress = Optional[Callable[[float, str], Any]]
KeyFrame = Union[tuple[float, Vector], tuple[float, Vector, Quaternion]]
Report = dict[str, Any]

__version__: str

class Error(RuntimeError):
    report: Optional[Report]

class Material:
    def __init__(
        self,
        preset: Optional[str] = None,
        *,
        density_kg_m3: float = ...,
        youngs_modulus_pa: float = ...,
        poisson_ratio: float = ...,
        damping_ratio: float = ...,
        shape_damping_per_s: float = ...,
        friction: float = ...,
        rubberlike: float = ...,
        second_invariant_share: float = ...,
        locking_elongation: float = ...,
        yield_stress_pa: float = ...,
        hardening_pa: float = ...,
        relaxation_time_s: float = ...,
        tensile_strength_pa: float = ...,
        elongation_at_break: float = ...,
        toughness_j_m2: float = ...,
        adhesion_pa: float = ...,
        healing_time_s: float = ...,
    ) -> None: ...
    @staticmethod
    def presets() -> list[str]: ...
    def __eq__(self, other: object) -> bool: ...
    @property
    def density_kg_m3(self) -> float: ...
    @property
    def youngs_modulus_pa(self) -> float: ...
    @property
    def poisson_ratio(self) -> float: ...
    @property
    def damping_ratio(self) -> float: ...
    @property
    def shape_damping_per_s(self) -> float: ...
    @property
    def friction(self) -> float: ...
    @property
    def rubberlike(self) -> float: ...
    @property
    def second_invariant_share(self) -> float: ...
    @property
    def locking_elongation(self) -> float: ...
    @property
    def yield_stress_pa(self) -> float: ...
    @property
    def hardening_pa(self) -> float: ...
    @property
    def relaxation_time_s(self) -> float: ...
    @property
    def tensile_strength_pa(self) -> float: ...
    @property
    def elongation_at_break(self) -> float: ...
    @property
    def toughness_j_m2(self) -> float: ...
    @property
    def adhesion_pa(self) -> float: ...
    @property
    def healing_time_s(self) -> float: ...

class Part:
    @property
    def name(self) -> str: ...
    @property
    def path(self) -> str: ...
    @property
    def color(self) -> Optional[list[float]]: ...
    @property
    def volume(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def faces(self) -> int: ...
    @property
    def box(self) -> tuple[Floats, Floats]: ...
    @property
    def is_closed(self) -> bool: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def vertices(self) -> Floats: ...
    @property
    def triangles(self) -> Integers: ...
    @property
    def face_of_triangle(self) -> Integers: ...

class Model:
    @property
    def parts(self) -> list[Part]: ...
    @property
    def file(self) -> str: ...
    @property
    def format(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def missing(self) -> list[str]: ...

class Filling:
    name: str
    kind: str
    velocity: Floats
    angular_velocity: Floats
    is_rigid: bool
    structural_friction: float
    def add_region(self, material: Material, objects: Sequence[int], name: str = "") -> None: ...
    @property
    def part(self) -> Part: ...
    @property
    def material(self) -> Material: ...
    @property
    def spacing(self) -> float: ...
    @property
    def warning(self) -> str: ...
    @property
    def rest(self) -> Floats: ...
    @property
    def volumes(self) -> Floats: ...
    def __len__(self) -> int: ...

class Body:
    @property
    def filling(self) -> Filling: ...
    @property
    def name(self) -> str: ...
    @property
    def positions(self) -> Floats: ...
    @property
    def displacements(self) -> Floats: ...
    @property
    def strains(self) -> Floats: ...
    @property
    def stresses(self) -> Floats: ...
    @property
    def von_mises(self) -> Floats: ...
    def surface(self, progress: Progress = None) -> tuple[Floats, Integers]: ...

class Tool:
    @property
    def name(self) -> str: ...
    @property
    def position(self) -> Floats: ...
    @property
    def rotation(self) -> list[float]: ...
    @property
    def force(self) -> Floats: ...
    @property
    def moment(self) -> Floats: ...
    @property
    def peak_force(self) -> float: ...
    def hold(self) -> None: ...
    def drive(self, velocity: Vector, angular_velocity: Vector = ...) -> None: ...
    def go_to(self, position: Vector, rotation: Optional[Quaternion] = None) -> None: ...
    def follow(self, keyframes: Sequence[KeyFrame]) -> None: ...
    def place(self, position: Vector, rotation: Optional[Quaternion] = None) -> None: ...
    def reshape(
        self,
        kind: Literal["box", "ball", "cylinder", "wedge", "plate"],
        size: Union[float, Sequence[float]],
        *,
        friction: float = 0.4,
        adhesion: float = 0.0,
        speed_limit: float = 0.5,
        force_limit: Optional[float] = None,
        rolls: bool = False,
    ) -> None: ...
    def rename(self, name: str) -> None: ...
    def remove(self) -> None: ...

class ToolPart:
    @property
    def size(self) -> Floats: ...

class Fixture:
    @property
    def force(self) -> Floats: ...
    @property
    def moment(self) -> Floats: ...
    @property
    def center(self) -> Floats: ...
    def move(
        self,
        velocity: Vector,
        center: Optional[Vector] = None,
        angular_velocity: Vector = ...,
        angle: Optional[float] = None,
    ) -> None: ...
    def rename(self, name: str) -> None: ...
    def release(self) -> None: ...

class Moment:
    @property
    def time(self) -> float: ...

class Simulation:
    def __init__(
        self,
        fillings: Sequence[Filling],
        *,
        gravity: Vector = ...,
        floor: Optional[float] = None,
        floor_friction: float = 0.4,
        floor_adhesion: float = 0.0,
        integrator: Literal["automatic", "semi-implicit-euler", "implicit-euler", "forward-euler"] = "automatic",
        time_step: Optional[float] = None,
        glued: bool = False,
        refilling: bool = True,
        vicinity: str = ...,
        mass_scaling_time_step: Optional[float] = None,
    ) -> None: ...
    @property
    def bodies(self) -> list[Body]: ...
    def fix(
        self,
        body: int = 0,
        *,
        box: Optional[tuple[Vector, Vector]] = None,
        faces: Sequence[int] = ...,
        objects: Sequence[int] = ...,
        name: str = "fixture",
        velocity: Vector = ...,
    ) -> Fixture: ...
    def add_tool(
        self,
        kind: Literal["box", "ball", "cylinder", "wedge", "plate"],
        size: Union[float, Sequence[float]],
        position: Vector,
        *,
        rotation: Optional[Quaternion] = None,
        name: str = "",
        keyframes: Sequence[KeyFrame] = ...,
        velocity: Optional[Vector] = None,
        angular_velocity: Vector = ...,
        friction: float = 0.4,
        adhesion: float = 0.0,
        speed_limit: float = 0.5,
        force_limit: Optional[float] = None,
        rolls: bool = False,
    ) -> Tool: ...
    def set_gravity(self, gravity: Vector) -> None: ...
    def set_floor(self, height: Optional[float], *, friction: float = 0.4, adhesion: float = 0.0) -> None: ...
    def set_integrator(self, integrator: str) -> None: ...
    def set_pace(self, pace: Literal["full", "rough", "wide", "exact"]) -> None: ...
    def set_material(self, material: Material, body: int = 0, objects: Sequence[int] = ...) -> None: ...
    def set_body_kind(self, kind: Literal["deformable", "rigid", "glue"], body: int = 0) -> None: ...
    def renormalize(self, body: int = 0, *, objects: Sequence[int] = ..., duration: float = 0.0) -> None: ...
    def refill(self, body: int = 0, *, spacing: float = 0.0) -> None: ...
    def cut(self, point: Vector, normal: Vector, body: int = 0) -> None: ...
    def carry_out(
        self, command: dict[str, Any], tool_parts: Sequence[ToolPart] = ...
    ) -> Union[Tool, Fixture, None]: ...
    def step(self, steps: int = 1) -> None: ...
    def step_to(self, step: int) -> None: ...
    def run(
        self,
        seconds: float,
        callback: Optional[Callable[[Simulation], Any]] = None,
        every: float = ...,
    ) -> None: ...
    def settle(self, duration: float = ..., progress: Progress = None) -> dict[str, float]: ...
    def reset(self) -> None: ...
    def keep(self) -> Moment: ...
    def go_to(self, moment: Moment) -> None: ...
    @property
    def time(self) -> float: ...
    @property
    def time_step(self) -> float: ...
    @property
    def steps(self) -> int: ...
    @property
    def state_hash(self) -> str: ...
    @property
    def energy(self) -> dict[str, float]: ...
    def export(
        self,
        path: Path,
        *,
        unit: str = "",
        tolerance: float = 0.0,
        ap214: bool = False,
        text: bool = False,
        progress: Progress = None,
    ) -> Optional[Report]: ...

class NumberDeformation: ...
class FieldDeformation: ...

def read(
    path: Union[Path, Sequence[Path]],
    *,
    unit: str = "",
    parts: Sequence[str] = ...,
    heal: bool = True,
    caps_flat_openings: bool = False,
    linear_deflection: float = ...,
    angular_deflection: float = ...,
    relative_deflection: float = ...,
    progress: Progress = None,
) -> Model: ...
def tool_parts(project: Path) -> list[ToolPart]: ...
def fill(
    part: Part,
    *,
    spacing: Optional[float] = None,
    objects: Optional[float] = None,
    cells_across: Optional[float] = None,
    cells_across_wall: Optional[float] = None,
    material: Optional[Material] = None,
    open: bool = False,
    published: bool = False,
    progress: Progress = None,
) -> Filling: ...
def run(
    recipe: Union[Path, dict[str, Any]],
    out: Path = ".",
    *,
    settings: dict[str, Any] = ...,
    folder: Path = ".",
    csv: Path = "",
    probes: Path = "",
    progress: Progress = None,
) -> Report: ...
def morph(
    part: Path,
    deformations: Union[
        Path, NumberDeformation, FieldDeformation, Sequence[Union[NumberDeformation, FieldDeformation]]
    ],
    out: Path,
    *,
    factor: float = 1.0,
    parts: Sequence[str] = ...,
    unit: str = "",
    tolerance: float = 0.0,
    progress: Progress = None,
) -> Report: ...
def morph_by_physics(
    part: Path,
    deformation: NumberDeformation,
    out: Path,
    *,
    material: str,
    duration: Optional[float] = None,
    let_go: bool = False,
    objects: Optional[int] = None,
    parts: Sequence[str] = ...,
    unit: str = "",
    tolerance: float = 0.0,
    progress: Progress = None,
) -> Report: ...
def bend(
    angle: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def twist(
    angle: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def taper(
    factor: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def stretch(
    factor: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def shear(
    shift: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def scale(
    factor: float,
    *,
    axis: Optional[Vector] = None,
    side: Optional[Vector] = None,
    origin: Optional[Vector] = None,
    start: Optional[float] = None,
    end: Optional[float] = None,
    radius: Optional[float] = None,
    neutral: Optional[float] = None,
    k_factor: Optional[float] = None,
    stays: float = 0.0,
    ease: bool = False,
) -> NumberDeformation: ...
def field(
    path: Path,
    *,
    factor: float = 1.0,
    step: Optional[int] = None,
    component: str = "",
    unit: str = "",
    keep_faces: Sequence[str] = ...,
    fade: Optional[float] = None,
    lock: str = "",
    in_place: bool = False,
) -> FieldDeformation: ...
def rotation(axis: Vector, angle: float) -> Quaternion: ...
def example(name: str) -> str: ...

# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
"""Planes of one array, functions of lists of planes, and planes that are tracked from frame to
frame."""

import warnings as python_warnings
from copy import copy
from typing import Any, Dict, Iterable, List, Literal, NamedTuple, Optional, Sequence, Tuple
from typing import Union, get_args

import numpy as np
from numpy.typing import NDArray

from . import _pcl_ops
from ._arguments import (
    Points, Up, Vector, checked_number, did_you_mean, finite_vector, is_same_array, named_parameters,
    parameters_of, points_array, pose_matrix, single_precision, up_direction, with_given)


def _of_segment(name: str, doc: str) -> Any:
    """The attribute with this name of the extension's class Segment, with a docstring."""
    return property(getattr(_pcl_ops.Segment, name).fget, doc=doc)


def _of_extent(position: int, doc: str) -> Any:
    """The entry of _Extent at this position, with a docstring."""
    return property(lambda plane: plane._extent()[position], doc=doc)


Kind = Literal["floor", "ceiling", "wall", "slab", "roof", "ramp", "table", "other"]

# The columns of the programs' tables of planes.
TABLE_COLUMNS = (
    "orientation", "kind", "points", "a", "b", "c", "d", "centroid_x", "centroid_y", "centroid_z",
    "normal_x", "normal_y", "normal_z", "rms", "area", "length", "width", "slope", "aspect",
    "height")


def _default_tolerance() -> float:
    """The angle_tolerance of all methods by default."""
    return parameters_of(_pcl_ops.merge_planes())["angle_tolerance"][0]


class _Naming(NamedTuple):
    """What the orientation and the kind of a plane follow from."""

    planes: List["Plane"]
    """All planes that were found together; empty for a plane of a pickle, which has its kind."""
    up: Vector = (0.0, 0.0, 1.0)
    angle_tolerance: float = _default_tolerance()
    viewpoint: Optional[Vector] = None
    """The position of the sensor; None if it is not known."""


class Plane(_pcl_ops.Segment):
    """A plane and the points on it, in the frame and the unit of their array.

    Hull, area, length and width are computed when first asked for, from the array as it is
    then, or from the copy of an array in another byte order. A pickle of a plane contains its
    array; planes that are pickled in one list share it.
    """

    normal: NDArray[np.float64] = _of_segment("normal", "(3,): unit normal, towards the viewpoint.")
    centroid: NDArray[np.float64] = _of_segment("centroid", "(3,): mean of the inliers, on the plane.")
    coefficients: NDArray[np.float64] = property(
        lambda plane: np.append(plane.normal, -plane.normal @ plane.centroid),
        doc="(4,): normal and d of a x + b y + c z + d = 0.")
    rms: float = _of_segment("rms", "Root mean square distance of the inliers to the plane.")
    noise: Optional[float] = _of_segment("noise", """The standard deviation of the surrounding points from
        their surface, the median over the plane; at most 4 times what is usual at their density.
        None for other methods than "ops", for a given surfels_voxel_size, and for exact
        points.""")
    orientation: Literal["horizontal", "vertical", "other"] = _of_segment(
        "orientation", "By up and angle_tolerance.")
    inliers: NDArray[np.int32] = _of_segment(
        "inliers", "(n,), read-only: rows of the array that are on the plane, ascending.")
    axes: NDArray[np.float64] = _of_segment("axes", """(2, 3): unit vectors u and v in the plane,
        u x v = normal, those of covariance. They depend on the normal alone.""")
    covariance: Optional[NDArray[np.float64]] = property(
        lambda plane: _pcl_ops.covariance(*plane._own_points(), plane),
        doc="""(3, 3): covariance of the errors of (tilt along u [rad], tilt along v [rad],
        offset). With errors (a, b, c) the surface has the height c + a s + b t over the plane at
        centroid + s u + t v. Right where neighboring points err alike, too, as in images of
        depth cameras; from the array as it is. None for inliers in fewer than four of the 64
        blocks the plane is divided into.""")
    independent_covariance: Optional[NDArray[np.float64]] = _of_segment(
        "independent_covariance", """(3, 3): the same for noise that is independent from point to
        point, by the moments alone; far too small for depth cameras. None for fewer than four
        inliers.""")
    hull: NDArray[np.float64] = _of_extent(0, """(m, 3): corners of the convex outline, on the
        plane, counter-clockwise seen from the side the normal points to, the first not
        repeated.""")
    area: float = _of_extent(1, "Area of the hull.")
    length: float = _of_extent(2, "Longer side of the smallest rectangle around the hull.")
    width: float = _of_extent(3, "Shorter side of that rectangle.")

    @property
    def lies_on(self) -> Optional[int]:
        """For a piece the number of the plane it lies on: planes are numbered from 0, by falling
        size. Else None."""
        return self._lies_on

    @property
    def kind(self) -> Kind:
        """What it is in a building: the result of plane_kinds for all planes it was found with, by
        their up. It is computed for all of them when the first is asked for."""
        if self._kind is None:
            planes = self._named_with.planes
            for plane, kind in zip(planes, _kinds_as_found(planes)):
                plane._kind = kind
        return self._kind

    def concave_outline(self, alpha: float = 0.0) -> Tuple[List[NDArray[np.float64]], float]:
        """The concave outline with its holes, as doors and windows, and its area without them.

        alpha: radius of a circle that fits into holes and bays, to begin with; 0: six times
            the mean distance of neighboring points. It grows until one outline is around
            99 % of the inliers.

        Returns (rings, area): arrays of shape (m, 3), first the outline, counter-clockwise as
        hull is, then the holes, clockwise; none where the inliers span no area.
        """
        radius = checked_number("alpha", alpha, lambda length: length >= 0.0, "a length or 0")
        points, origin = self._own_points()
        rings, area = _pcl_ops.concave_extent(points, origin, self, radius)
        return [np.reshape(ring, (-1, 3)) + origin for ring in rings], area

    def distances(self, points: Points) -> NDArray[np.float64]:
        """Signed distance of any points to the plane, positive where the normal points to.

        points: array as for segment; the result has its shape without the last side.
        """
        # Relative to the centroid, as the offset d of the plane has few digits left far from zero.
        distances = (points_array(points) - self.centroid) @ self.normal
        return distances.reshape(np.shape(points)[:-1])

    def as_dict(self, up: Optional[Up] = None) -> Dict[str, Union[int, float, str, None]]:
        """Numbers and words of the plane by name, those of the columns of the programs' tables.

        slope and aspect in degrees, as there: the angle to the horizontal, and where the plane
        goes down, clockwise from y as seen from above; None where it is level, or z is not up.
        height: of the centroid along up, by default the up that the plane was found with.
        """
        axis = up_of([self], up)
        cosine = float(self.normal @ axis)
        sine = float(np.linalg.norm(np.cross(self.normal, axis)))
        # Of a normal that points up, or of a vertical plane to its front.
        x, y = (self.normal if cosine >= 0.0 or self.orientation == "vertical"
                else -self.normal)[:2]
        has_aspect = axis[2] == 1.0 and (x != 0.0 or y != 0.0)
        slope = float(np.degrees(np.arctan2(sine, abs(cosine))))
        aspect = float(np.degrees(np.arctan2(x, y))) % 360.0 if has_aspect else None
        return dict(zip(TABLE_COLUMNS, (
            self.orientation, self.kind, len(self.inliers), *self.coefficients.tolist(),
            *self.centroid.tolist(), *self.normal.tolist(), self.rms, self.area, self.length,
            self.width, slope, aspect, float(self.centroid @ axis))))

    def __init__(self, segment: Any, points: NDArray[Any]) -> None:
        """Takes the contents of the extension's segment, which has none afterwards.

        points: the user's array in which the plane was found.
        """
        super().__init__(segment)
        self._points = points
        self._known_extent = None
        self._lies_on: Optional[int] = None
        self._kind: Optional[Kind] = None
        self._named_with = _Naming([self])

    def __repr__(self) -> str:
        known = f", {self._kind}" if self._kind else ""
        return (f"<pcl_ops.Plane: {self.orientation}{known}, {len(self.inliers)} points, "
                f"rms {self.rms:.3g}>")

    def __reduce__(self) -> Any:
        return _plane, (self._points, *self._segment_state()), {
            "_lies_on": self._lies_on, "_kind": self.kind, "_known_extent": self._known_extent,
            "_named_with": self._named_with._replace(planes=[])}

    def _segment_state(self, **changed: Any) -> Tuple[Any, ...]:
        """The arguments of the extension's Segment; changed: values in place of the plane's."""
        centroid, normal, orientation, moments, inliers, noise = (
            changed.get(name, getattr(self, name))
            for name in ("centroid", "normal", "orientation", "_moments", "inliers", "noise"))
        return centroid, normal, orientation, *moments, inliers, noise

    def _extent(self) -> "_Extent":
        if self._known_extent is None:  # not before it is needed: it takes long
            self._known_extent = _extent_of(self._points.take(self.inliers, axis=0), self)
        return self._known_extent

    def _own_points(self) -> Tuple[NDArray[np.float32], NDArray[np.float64]]:
        """The inliers in single precision, and the origin that they are relative to."""
        return single_precision(self._points.take(self.inliers, axis=0))


# Hull, area, length and width.
_Extent = Tuple[NDArray[np.float64], float, float, float]


def _extent_of(points: NDArray[Any], segment: Any) -> _Extent:
    """The extent of points on a plane.

    points: those of the segment's inliers, in their order.
    """
    single, origin = single_precision(points)
    hull, *sizes = _pcl_ops.extent(single, origin, segment)
    return np.reshape(hull, (-1, 3)) + origin, *sizes


def _plane(points: NDArray[Any], *segment_state: Any) -> Plane:
    """A plane from Plane._segment_state; pickles call it."""
    return Plane(_pcl_ops.Segment(*segment_state), points)


Planes = Sequence[Plane]
Labels = NDArray[np.int32]


class ResultWarning(UserWarning):
    """What is doubtful about a result; its text says what to do about it."""

    code: str
    """A word that stays the same, such as "thick-planes"."""

    def __init__(self, code: str, text: str) -> None:
        super().__init__(text)
        self.code = code

    def __reduce__(self) -> Any:
        return ResultWarning, (self.code, str(self))


# The largest number of warnings about a result, the same as in the programs.
MAX_WARNINGS = 3


class FoundPlanes(List[Plane]):
    """Planes by falling number of points, and the lengths they were found with."""

    voxel_size: Optional[float] = None
    """Edge of the voxels; None if the method has none."""
    distance_threshold: Optional[float] = None
    """The largest distance of a point to its plane; the median over the planes if it follows
    their noise. None if it would follow the noise and no plane was found."""
    up: Tuple[float, float, float] = (0.0, 0.0, 1.0)
    """Against gravity: orientations are named by it."""
    up_confidence: Optional[float] = None
    """With up="auto", how sure the planes are of up, 0 to 1; None if they cannot tell it."""
    warnings: Sequence[ResultWarning] = ()
    """What is doubtful about the planes, the most important first. Each one was also given to
    warnings.warn."""
    # Is given when kinds are asked for: they need to know which way is up.
    _warning_of_kinds: Optional[ResultWarning] = None

    def _warn(self, warning: ResultWarning, stacklevel: int) -> None:
        """Gives a warning and adds it to warnings; stacklevel: as of warnings.warn."""
        self.warnings = [*self.warnings, warning]
        python_warnings.warn(warning, stacklevel=stacklevel)

    def _warn_of_kinds(self, stacklevel: int) -> None:
        """Gives the warning about kinds, once.

        stacklevel: 1 is this method, 2 its caller, and so on.
        """
        warning, self._warning_of_kinds = self._warning_of_kinds, None
        if warning:
            self._warn(warning, stacklevel + 1)

    @property
    def kind(self) -> NDArray[np.str_]:
        """(n,): the kind of each of the n planes; planes.kind == "wall" tells which are walls."""
        self._warn_of_kinds(3)
        longest = "<U7"  # "ceiling"
        return np.array([plane.kind for plane in self], dtype=longest)

    def as_dict(self) -> Dict[str, List[Any]]:
        """The columns of Plane.as_dict by name, for pandas.DataFrame(planes.as_dict())."""
        rows = [plane.as_dict(self.up) for plane in self]
        return {name: [row[name] for row in rows] for name in TABLE_COLUMNS}


class PlaneEdge(NamedTuple):
    """A part of the common line of two planes, with points of both beside it."""

    planes: Tuple[int, int]
    """Positions in the list of planes, ascending."""
    start: NDArray[np.float64]
    """(3,): one end. The other end is from here in the direction of the cross product of the
    normals."""
    end: NDArray[np.float64]
    angle: float
    """Between the planes, 0 to pi / 2 [rad]."""


class PlaneCorner(NamedTuple):
    """The common point of three planes of which each two have an edge there."""

    planes: Tuple[int, int, int]
    """Positions in the list of planes, ascending."""
    position: NDArray[np.float64]


def _array_of(planes: Planes) -> NDArray[Any]:
    """The one array in which all planes were found; raises if there are several."""
    if not all(is_same_array(plane._points, planes[0]._points) for plane in planes):
        raise ValueError("planes: they are of different arrays, whose rows cannot be told apart")
    return planes[0]._points if planes else np.empty((0, 3), np.float32)


def plane_list(name: str, planes: Any) -> List[Plane]:
    """A list of planes from any iterable or from one plane; raises if it has anything else.

    FoundPlanes stay what they are, as they know their up.
    """
    if isinstance(planes, FoundPlanes):
        listed = planes
    else:
        listed = list(planes) if isinstance(planes, Iterable) else [planes]
    if not all(isinstance(plane, Plane) for plane in listed):
        raise TypeError(f"{name}: not a list of pcl_ops.Plane: {planes!r:.80}")
    return listed


def name_together(
    planes: List[Plane], up: Vector, angle_tolerance: float, viewpoint: Optional[Vector]
) -> None:
    """Sets what the kind of each plane follows from: all of these planes and the arguments."""
    planes = list(planes)  # a copy, as users may remove planes from their list
    for plane in planes:
        plane._kind, plane._named_with = None, _Naming(planes, up, angle_tolerance, viewpoint)


def _own_up(planes: List[Plane]) -> Vector:
    """The up that planes were found with: that of the list, or else of the first plane."""
    if planes and not isinstance(planes, FoundPlanes):
        return planes[0]._named_with.up
    return getattr(planes, "up", FoundPlanes.up)


def up_of(planes: List[Plane], given: Optional[Up]) -> NDArray[np.float64]:
    """The unit vector against gravity that is given, or by default that of the planes."""
    return up_direction(_own_up(planes) if given is None else given)


def _named_by(up: NDArray[np.float64], planes: List[Plane]) -> List[Plane]:
    """The planes as segment would find them with this up.

    They are the given planes if these were found with it; else copies with other orientations.
    In copies normals are turned up if the position of the sensor is not known.
    """
    if all(np.array_equal(up_direction(plane._named_with.up), up) for plane in planes):
        return planes
    _, _, tolerance, viewpoint = planes[0]._named_with
    is_sensor_unknown = viewpoint is not None and not np.any(viewpoint) and (
        _viewpoint_if_seen(planes[0]._points, viewpoint) is None)
    copies = []
    for plane in planes:
        cosine = float(plane.normal @ up)
        orientation = ("horizontal" if np.arccos(min(1.0, abs(cosine))) <= tolerance else
                       "vertical" if np.arcsin(min(1.0, abs(cosine))) <= tolerance else "other")
        # The normals of vertical planes are turned towards zero, as if a sensor were there.
        points_wrong = plane.normal @ plane.centroid > 0.0 if orientation == "vertical" else cosine < 0.0
        is_turned = is_sensor_unknown and points_wrong
        normal = -plane.normal if is_turned else plane.normal
        state = plane._segment_state(orientation=orientation, normal=normal)
        copies.append(_plane(plane._points, *state))
        # The order of the corners of a hull depends on the side that the normal points to.
        copies[-1]._known_extent = None if is_turned else plane._extent()
    name_together(copies, up, tolerance, viewpoint)
    return copies


def _viewpoint_if_seen(points: NDArray[Any], viewpoint: Optional[Vector]) -> Optional[Vector]:
    """The viewpoint; None if the points cannot have been seen from there, or if it is None."""
    if viewpoint is None:
        return None
    single, origin = single_precision(points)
    is_seen = _pcl_ops.is_seen_from(single, finite_vector("viewpoint", viewpoint) - origin)
    return viewpoint if is_seen else None


def _kinds_as_found(planes: List[Plane], meter: float = 1.0) -> List[Kind]:
    """Kinds by the up and the viewpoint that the planes were found with.

    meter: the length of a meter in the unit of the planes.
    """
    if not planes:
        return []
    sensor = _viewpoint_if_seen(planes[0]._points, planes[0]._named_with.viewpoint)
    return plane_kinds(planes, meter=meter, viewpoint=sensor)


def plane_kinds(
    planes: Planes, up: Optional[Up] = None, meter: float = 1.0,
    viewpoint: Optional[Vector] = None,
) -> List[Kind]:
    """What planes are in a building, by their heights, sizes, slopes and surroundings.

    planes: all Plane of a cloud, with normals towards the sensor.
    up: vector against gravity, or "camera"; None: the up that the planes were found with. By
        another one orientations are named anew.
    meter: the length of a meter in the unit of the planes.
    viewpoint: the position of the sensor, if it is known: planes below it are no ceilings, and
        the ground tells which way is up if the sensor leans.

    Returns for each plane "floor", "ceiling", "wall", "slab", "roof", "ramp", "table" or "other".
    """
    listed = plane_list("planes", planes)
    axis = up_of(listed, up)
    unit = checked_number("meter", meter, lambda length: length > 0.0, "a length above 0")
    sensor = None if viewpoint is None else finite_vector("viewpoint", viewpoint)
    return _pcl_ops.kinds(_named_by(axis, listed), axis, unit, sensor)


@named_parameters("merge_planes")
def merge_planes(
    planes: Planes, *, up: Optional[Up] = None, angle_tolerance: Optional[float] = None,
    **parameters: Any,
) -> Tuple[List[Plane], Labels]:
    """Merge coplanar planes until no pair passes the test.

    planes: list of Plane of one array that share no points, as segment returns them; with
        merging_enabled=False segment does not merge them itself.
    up, angle_tolerance: decide which planes are horizontal and vertical [rad]; None: those that
        the planes were found with. up="camera" is camera_up().
    angle_threshold [rad], distance_threshold, noise_factor: limits for the angle between two
        planes and for their distance.

    Returns (merged, merged_into): a list of Plane by falling number of points; and an int32
    array with, for each of planes, the position in merged of the plane it became part of, -1
    if its points span no plane.
    """
    planes = plane_list("planes", planes)
    _, _, own_tolerance, viewpoint = planes[0]._named_with if planes else _Naming([])
    given = with_given(_pcl_ops.merge_planes(), {
        "up": _own_up(planes) if up is None else up,
        "angle_tolerance": own_tolerance if angle_tolerance is None else angle_tolerance,
        **parameters})
    points = _array_of(planes)
    inliers = np.concatenate([np.empty(0, np.int32), *(plane.inliers for plane in planes)])
    if len(np.unique(inliers)) < len(inliers):
        raise ValueError("planes: some share points, which would count twice; give those of one "
                         "segment")
    segments, merged_into = _pcl_ops.merge(planes, given)
    merged = [Plane(segment, points) for segment in segments]
    known = parameters_of(given)
    name_together(merged, known["up"][0], known["angle_tolerance"][0], viewpoint)
    return merged, np.array(merged_into, np.int32)


@named_parameters("filter_planes")
def filter_planes(
    planes: Planes, *, kind: Union[None, Kind, Sequence[Kind]] = None, up: Optional[Up] = None,
    **parameters: Any,
) -> Tuple[List[Plane], Dict[str, int]]:
    """Keep the planes that are wanted.

    planes: list of Plane, in an order that stays.
    kind: "wall" and the like, as Plane.kind says, or several: ("wall", "roof").
    orientation: "horizontal", "vertical" or "other".
    direction: vector (x, y, z) of any length; normals point along or against it, within
        direction_tolerance [rad].
    slope: (smallest, largest) angle between the plane and the horizontal [rad].
    up: vector against gravity, or "camera", for slope; None: the up that the planes were found
        with.
    min_points, min_area, min_width: smallest number of inliers, area of the hull and width of
        the rectangle around it.
    max_area, max_width: largest area and width; None: any.
    size: (width, height, tolerance) of a board: the sides of that rectangle, in any order,
        and by how much each may differ.
    max_planes: the largest number of planes to keep; the first ones that pass are kept.

    Returns (kept, dropped): the list of Plane, and a dict with the number of planes that each
    argument dropped; a plane counts once, for the first argument it fails.
    """
    listed = plane_list("planes", planes)
    given = with_given(_pcl_ops.filter_planes(), {
        "up": _own_up(listed) if up is None else up, **parameters})
    of_kind = listed
    if kind is not None:
        wanted_kinds = _kinds_of(kind)
        if isinstance(planes, FoundPlanes):
            planes._warn_of_kinds(3)
        of_kind = [plane for plane in listed if plane.kind in wanted_kinds]
    kept, dropped = _pcl_ops.filter(of_kind, given)
    return [of_kind[i] for i in kept], {"kind": len(listed) - len(of_kind), **dropped}


def _kinds_of(given: Any) -> List[str]:
    """A list of kinds from one or several; raises if one is unknown."""
    known = get_args(Kind)
    if not isinstance(given, Iterable):
        raise TypeError(f"kind: has to be one or several of {', '.join(known)}, not {given!r:.80}")
    kinds = [given] if isinstance(given, str) else list(given)
    for kind in kinds:
        if not (isinstance(kind, str) and kind in known):
            raise ValueError(f"kind: {kind!r:.80} is unknown{did_you_mean(kind, known)}; "
                             f"there are {', '.join(known)}")
    return kinds


class PlaneMove(NamedTuple):
    """How a plane was moved."""

    angle: float
    """By how much it turned about its centroid [rad]."""
    offset: float
    """How far it then moved along its normal."""
    displacement: float
    """Root mean square change of the distances of its points to it, in multiples of its rms; for
    a plane that was not moved the displacement it would have had."""
    is_moved: bool
    direction: int
    """Planes with the same number are parallel."""
    level: int
    """Planes with the same number are coplanar."""


@named_parameters("regularize_planes")
def regularize_planes(planes: Planes, **parameters: Any) -> Tuple[List[Plane], List[PlaneMove]]:
    """Make nearly parallel, orthogonal and coplanar planes exactly so.

    planes: list of Plane in one frame, as of one array or of a tracker.
    max_angle: planes that are parallel or orthogonal within this angle are made so [rad].
    max_offset: parallel planes within this distance are made coplanar; None: three times their
        joint rms.
    max_displacement: how far a plane may move relative to its points, in multiples of its rms.

    Returns (regularized, moves): a list of Plane in the order of planes, and how each moved.
    """
    planes = plane_list("planes", planes)
    found, moves = _pcl_ops.regularize(
        planes, with_given(_pcl_ops.regularize_planes(), parameters))
    regularized = [Plane(segment, before._points) for segment, before in zip(found, planes)]
    for after, before in zip(regularized, planes):
        after._lies_on = before._lies_on
        if not len(before.inliers):  # of a tracker: only its outline is known
            corners = np.arange(len(before.hull), dtype=np.int32)
            after._known_extent = _extent_of(
                before.hull, _pcl_ops.Segment(*after._segment_state(inliers=corners)))
    if planes:
        name_together(regularized, *planes[0]._named_with[1:])
    return regularized, [PlaneMove(*move) for move in moves]


@named_parameters("find_plane_edges")
def find_plane_edges(
    planes: Planes, **parameters: Any
) -> Tuple[List[PlaneEdge], List[PlaneCorner]]:
    """Where planes meet: edges of two, corners of three.

    planes: list of Plane of one array.
    reach: how near to their common line two planes must both have points.
    max_gap: the longest gap of points along an edge.
    min_length: shorter edges are left out. None for these three: they follow the noise and the
        distance of neighboring points.
    min_angle: planes at a smaller angle have no edge [rad].

    Returns (edges, corners), in ascending order of their planes.
    """
    planes = plane_list("planes", planes)
    single, origin = single_precision(_array_of(planes))
    edges, corners = _pcl_ops.edges(
        single, origin, planes, with_given(_pcl_ops.find_plane_edges(), parameters))
    return ([PlaneEdge(tuple(of_planes), *rest) for of_planes, *rest in edges],
            [PlaneCorner(tuple(of_planes), position) for of_planes, position in corners])


class PlanOpening(NamedTuple):
    """A gap of a wall at the height of the cut: a door, a window."""

    start: NDArray[np.float64]
    end: NDArray[np.float64]
    sill: Optional[float]
    """Height over the floor of the top of the wall below it; None if no wall was seen there."""
    head: Optional[float]
    """Height over the floor of the bottom of the wall above it; None if none was seen."""
    rooms: Tuple[Optional[int], Optional[int]]
    """The rooms before and behind the wall, by position in the list of rooms, or None."""
    is_door: bool
    """Whether no wall was seen below it, or only a threshold lower than 0.25 m."""


class PlanWall(NamedTuple):
    """One side of a wall, from corner to corner; the room is to the left from start to end."""

    start: NDArray[np.float64]
    end: NDArray[np.float64]
    thickness: Optional[float]
    """Distance to its other side; None if that was not seen."""
    openings: List[PlanOpening]
    """From start to end."""
    planes: Tuple[int, ...]
    """Positions in the list of planes."""


class PlanRoom(NamedTuple):
    """A room, as far as its walls were seen."""

    rings: List[NDArray[np.float64]]
    """(m, 2) each: the outline, counter-clockwise, then holes, clockwise."""
    area: float
    enclosed: float
    """The share of walls in the outline, 0 to 1."""
    floor: Optional[float]
    ceiling: Optional[float]
    """Heights along up; None where they were not seen."""
    middle: NDArray[np.float64]
    """A position inside, for a name."""
    unseen: List[NDArray[np.float64]]
    """(2, 2) each: the ends of the parts of the outline that have no wall."""
    doors_to: Tuple[int, ...]
    """The rooms that doors lead to, positions in the list of rooms."""


class FloorPlan(NamedTuple):
    """A level cut through a building. Where up is z, x and y are those of the planes."""

    walls: List[PlanWall]
    rooms: List[PlanRoom]
    """By falling area."""
    floor: float
    """Height of the floor."""
    height: float
    """Height of the cut."""


def draw_floor_plan(planes: Planes, up: Optional[Up], parameters: Dict[str, Any]) -> FloorPlan:
    """The plan that floor_plan returns.

    Warnings name the line that called the caller of this function, as that is the user's line.
    """
    if isinstance(planes, FoundPlanes):
        planes._warn_of_kinds(4)
    planes = plane_list("planes", planes)
    axis = up_of(planes, up)
    planes = _named_by(axis, planes)
    given = with_given(_pcl_ops.floor_plan(), parameters)
    meter = parameters.get("meter", 1.0)
    kinds = [plane.kind for plane in planes] if meter == 1.0 else _kinds_as_found(planes, meter)
    single, origin = single_precision(_array_of(planes))
    walls, rooms, floor, height = _pcl_ops.plan(single, origin, planes, kinds, axis, given)
    if not walls and planes:
        context = _pcl_ops.ResultContext()
        context.has_meter = meter != 1.0
        context.set_plan(0, kinds.count("wall"), "floor" in kinds)
        code, text = _pcl_ops.warnings(single, origin, [], context)[0]
        python_warnings.warn(ResultWarning(code, text), stacklevel=3)
    return FloorPlan(
        [PlanWall(start, end, thickness, [PlanOpening(*opening) for opening in openings],
                  tuple(of_planes))
         for start, end, thickness, openings, of_planes in walls],
        [PlanRoom([np.reshape(ring, (-1, 2)) for ring in rings], *rest,
                  [np.array(ends) for ends in unseen], doors)
         for rings, *rest, unseen, doors in rooms],
        floor, height)


@named_parameters("floor_plan")
def floor_plan(planes: Planes, up: Optional[Up] = None, **parameters: Any) -> FloorPlan:
    """Draw the floor plan of the planes of a room, or of several: walls, openings, rooms.

    planes: all Plane of one array, as segment gives them. Their kind says what makes the plan.
    up: vector against gravity, or "camera"; None: the up that the planes were found with.
    cut_height: height over the lowest floor at which walls are cut.
    min_opening, max_opening: the shortest and longest gap that is an opening.
    max_snap: how far ends of walls are moved to the wall they meet.
    min_room: area of the smallest room.
    meter: the length of a meter in the unit of the planes, 1000 for millimeters; all other
        lengths here, and the plan, are in meters.
    """
    return draw_floor_plan(planes, up, parameters)


@named_parameters("estimate_up_axis")
def estimate_up_axis(
    planes: Planes, viewpoint: Vector = (0.0, 0.0, 0.0), **parameters: Any
) -> Optional[Tuple[NDArray[np.float64], float]]:
    """Which way is up in a room, by its planes alone.

    planes: list of Plane in one frame, as segment returns them or of a tracker, with normals
        towards the viewpoint.
    viewpoint: the position of the sensor, in the frame of the planes.
    angle_tolerance: planes within this angle of horizontal or vertical count as such [rad].
    min_share: smallest share of the planes that must be horizontal, and that must be vertical.
    min_confidence: below it there is no answer.

    Returns (direction, confidence): a unit vector against gravity, and how sure it is, 0
    to 1. Or None if the planes cannot tell, or if the points were not seen from the viewpoint
    (is_seen_from), as then floors would be taken for ceilings.
    """
    planes = plane_list("planes", planes)
    sensor = finite_vector("viewpoint", viewpoint)
    found = _pcl_ops.up_axis(planes, sensor, with_given(_pcl_ops.estimate_up_axis(), parameters))
    arrays = {id(plane._points): plane._points for plane in planes}.values()
    are_seen = all(_viewpoint_if_seen(array, sensor) is not None for array in arrays)
    return found if found and are_seen else None


@named_parameters("match_planes")
def match_planes(
    previous: Planes, current: Planes, pose: Optional[NDArray[Any]] = None, **parameters: Any
) -> Tuple[Labels, NDArray[np.float64]]:
    """Find the planes of one frame again in the next.

    previous, current: lists of Plane, each in the frame of its own array.
    pose: array of shape (4, 4), the current frame in the previous one: a point p of the
        current frame is pose[:3, :3] @ p + pose[:3, 3] in the previous one. None: both frames
        are the same.
    rotation_error [rad], translation_error: how far the pose may be off, one standard
        deviation about and along any axis; rotations are about the zero of the current
        frame.
    min_overlap: the smallest share of the smaller of two planes that lies over the other.

    Returns (matches, pose): an int32 array with the position in previous of the plane that
    each of current continues, -1 for none; and the pose as the matched planes correct it.
    """
    matches, corrected = _pcl_ops.match(
        plane_list("previous", previous), plane_list("current", current), pose_matrix(pose),
        with_given(_pcl_ops.match_planes(), parameters))
    return np.array(matches, np.int32), corrected


class TrackedPlane(NamedTuple):
    """A plane with the number it has in all frames."""

    number: int
    """From 1, in the order of appearance."""
    plane: Plane
    """In the common frame, without inliers; hull, area, length and width are those of hull
    below, independent_covariance is that of the last frames, covariance is None."""
    last_seen: int
    """The last frame it was seen in, from 0."""
    first_seen: int
    times_seen: int
    hull: NDArray[np.float64]
    """(m, 3): convex outline of where it was seen in any frame, of rectangles with the moments
    of each."""


def _tracked(number: int, segment: Any, last_seen: int, first_seen: int, times_seen: int,
             hull: Any, *sizes: float) -> TrackedPlane:
    """A plane of the extension's tracker; sizes: area, length and width of the hull."""
    plane = Plane(segment, np.empty((0, 3), np.float32))
    corners = np.reshape(hull, (-1, 3))
    plane._known_extent = corners, *sizes
    return TrackedPlane(number, plane, last_seen, first_seen, times_seen, corners)


class _MotionOfSensor:
    """How far a sensor has moved along each axis of its own frames, by its poses."""

    MIN_LENGTH_ALONG_Z = 3.0  # [m]: a sensor that is only lifted moves less
    MIN_COSINE = 0.9  # of the angle between z and up

    def __init__(self) -> None:
        self._last_pose: Optional[NDArray[np.float64]] = None
        self._length_along_axes = np.zeros(3)
        self._was_reported = False

    def goes_up(self, pose: NDArray[np.float64], up: Optional[Vector]) -> bool:
        """Adds a pose. Whether z is up but the sensor moved mostly along z; true only once."""
        if self._last_pose is not None:
            motion = np.linalg.solve(self._last_pose, pose)
            self._length_along_axes += np.abs(motion[:3, 3])
        self._last_pose = pose
        x, y, z = self._length_along_axes
        is_z_up = up is not None and up[2] > self.MIN_COSINE
        is_first = (not self._was_reported and is_z_up
                    and z >= max(x, y, self.MIN_LENGTH_ALONG_Z))
        self._was_reported = self._was_reported or is_first
        return is_first


class PlaneTracker:
    """Numbers for planes that they keep from frame to frame, also where they are out of
    sight for a while. copy.copy it to try what a frame would do."""

    @named_parameters("match_planes")
    def __init__(
        self, memory: Optional[int] = None, max_distance: Optional[float] = None, **parameters: Any
    ) -> None:
        """memory: for how many frames a plane is remembered after it was last seen; None: for ever.
        max_distance: planes of which every part is farther from the sensor are forgotten.

        The others are those of match_planes; errors are from one frame to the next.
        """
        if memory is not None:
            memory = checked_number(
                "memory", memory, lambda frames: frames >= 0, "a number of frames or None", int)
        if isinstance(max_distance, (float, np.floating)) and max_distance == np.inf:
            max_distance = None
        if max_distance is not None:
            max_distance = checked_number(
                "max_distance", max_distance, lambda length: length > 0.0, "a length above 0 or None")
        self._tracker = _pcl_ops.Tracker(
            with_given(_pcl_ops.match_planes(), parameters), memory, max_distance)
        self._motion = _MotionOfSensor()
        self._sum_of_ups = np.zeros(3)

    def __copy__(self) -> "PlaneTracker":
        copied = PlaneTracker()
        copied._tracker = _pcl_ops.Tracker(self._tracker)
        copied._motion, copied._sum_of_ups = copy(self._motion), self._sum_of_ups
        return copied

    def __deepcopy__(self, _: Any) -> "PlaneTracker":
        return self.__copy__()

    def __reduce__(self) -> Any:
        raise TypeError("cannot pickle 'pcl_ops.PlaneTracker' objects")

    def track(self, planes: Planes, pose: Optional[NDArray[Any]] = None) -> NDArray[np.uint32]:
        """Number the planes of the next frame.

        planes: list of Plane as segment gives them, in the frame's own coordinates.
        pose: array of shape (4, 4), the frame in a common one, as for match_planes. Only
            how it moved since the frame before counts, so that poses may drift.

        Returns the number of each plane, all different; planes that were not seen before
        get new ones. Warns by ResultWarning, once, where the frames move along the up axis of
        their planes, as they do by poses of KITTI's camera.
        """
        frame, listed = pose_matrix(pose), plane_list("planes", planes)
        numbers = self._tracker.track(listed, frame)
        if listed:
            self._sum_of_ups = self._sum_of_ups + frame[:3, :3] @ up_of(listed, None)
        up = getattr(planes, "up", None)
        if self._motion.goes_up(frame, None if up is None else up_direction(up)):
            context = _pcl_ops.ResultContext()
            context.has_camera_poses = True
            no_points, origin = np.empty((0, 3), np.float32), np.zeros(3)
            code, text = _pcl_ops.warnings(no_points, origin, [], context)[0]
            python_warnings.warn(ResultWarning(code, text), stacklevel=2)
        return np.array(numbers, np.uint32)

    @property
    def planes(self) -> List[TrackedPlane]:
        """All planes that are remembered, by their numbers. Their kinds are told by all of them, and by
        the mean up of the frames."""
        tracked = [_tracked(*known) for known in self._tracker.planes]
        up = self._sum_of_ups if self._sum_of_ups.any() else FoundPlanes.up
        name_together([one.plane for one in tracked], up, _default_tolerance(), None)
        return tracked

    @property
    def pose(self) -> NDArray[np.float64]:
        """(4, 4): the last frame in the common one, as its planes say."""
        return self._tracker.pose

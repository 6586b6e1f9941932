# SPDX-FileCopyrightText: 2026 The pcl_ops authors
# SPDX-License-Identifier: BSD-3-Clause
from typing import Any, Dict, List, Literal, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import NDArray

__version__: str

Method = Literal["ops", "fspf", "kht"]
Preset = Literal["default", "paper"]
Orientation = Literal["horizontal", "vertical", "other"]
Points = Union[NDArray[np.float32], NDArray[np.float64]]
Vector = Union[Sequence[float], NDArray[Any]]

class Plane:
    @property
    def normal(self) -> NDArray[np.float64]: ...
    @property
    def centroid(self) -> NDArray[np.float64]: ...
    @property
    def coefficients(self) -> NDArray[np.float64]: ...
    @property
    def rms(self) -> float: ...
    @property
    def orientation(self) -> Orientation: ...
    @property
    def inliers(self) -> NDArray[np.int32]: ...
    @property
    def hull(self) -> NDArray[np.float64]: ...
    @property
    def area(self) -> float: ...
    @property
    def length(self) -> float: ...
    @property
    def width(self) -> float: ...
    @property
    def axes(self) -> NDArray[np.float64]: ...
    @property
    def covariance(self) -> Optional[NDArray[np.float64]]: ...

def segment(
    points: Points,
    method: Method = "ops",
    preset: Preset = "default",
    *,
    viewpoint: Vector = (0.0, 0.0, 0.0),
    **parameters: Any,
) -> Tuple[NDArray[np.int32], List[Plane]]: ...
def parameters(method: Method = "ops", preset: Preset = "default") -> Dict[str, Any]: ...
def merge_planes(
    planes: Sequence[Plane],
    *,
    up: Vector = (0.0, 0.0, 1.0),
    angle_tolerance: float = ...,
    enabled: bool = True,
    angle_threshold: float = ...,
    distance_threshold: Optional[float] = None,
    noise_factor: Optional[float] = None,
) -> Tuple[List[Plane], NDArray[np.int32]]: ...
def filter_planes(
    planes: Sequence[Plane],
    *,
    orientation: Optional[Orientation] = None,
    direction: Optional[Vector] = None,
    direction_tolerance: float = ...,
    min_points: int = 0,
    min_area: float = 0.0,
    min_width: float = 0.0,
    max_planes: Optional[int] = None,
) -> Tuple[List[Plane], Dict[str, int]]: ...
def match_planes(
    previous: Sequence[Plane],
    current: Sequence[Plane],
    pose: Optional[NDArray[Any]] = None,
    *,
    rotation_error: float = ...,
    translation_error: float = ...,
    min_overlap: float = ...,
) -> Tuple[NDArray[np.int32], NDArray[np.float64]]: ...
def estimate_up_axis(
    planes: Sequence[Plane],
    viewpoint: Vector = (0.0, 0.0, 0.0),
    *,
    angle_tolerance: float = ...,
    least_share: float = ...,
    least_confidence: float = ...,
) -> Optional[Tuple[NDArray[np.float64], float]]: ...
def evaluate(
    truth: NDArray[Any],
    result: NDArray[Any],
    points: Points,
    *,
    up: Vector = (0.0, 0.0, 1.0),
    angle_tolerance: float = ...,
) -> Dict[str, float]: ...

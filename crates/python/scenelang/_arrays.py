"""Arrays from and to the doubles of the compiled part: of NumPy where it is installed, else memoryviews and lists."""

from array import array
from typing import Any

try:
    import numpy
except ImportError:
    numpy = None  # type: ignore[assignment]


def flat(poses: Any, objects: int) -> tuple[Any, int, tuple[int, ...]]:
    """A buffer of doubles, how many numbers a pose has, and the leading shape: () or (environments,)."""
    if numpy is not None:
        poses = numpy.ascontiguousarray(poses, dtype=numpy.float64)
    shape = _shape(poses)
    if len(shape) not in (2, 3) or shape[-2] != objects or shape[-1] not in (6, 7):
        raise ValueError(
            f"poses have the shape [environments, {objects}, 7] (or [{objects}, 7] for one), not {list(shape)}; "
            "the objects are those of `Evaluator.objects`, in this order"
        )
    values = poses if numpy is not None else array("d", _numbers(poses, len(shape)))
    return values, shape[-1], tuple(shape[:-2])


def _shape(values: Any) -> tuple[int, ...]:
    if hasattr(values, "shape"):
        return tuple(values.shape)
    shape = []
    while hasattr(values, "__len__"):
        shape.append(len(values))
        if not shape[-1]:
            break
        values = values[0]
    return tuple(shape)


def _numbers(values: Any, depth: int) -> Any:
    if isinstance(values, memoryview):
        values = values.tolist()
    if depth <= 1:
        return values
    rows = [_numbers(part, depth - 1) for part in values]
    if len({len(row) for row in rows}) > 1:
        raise ValueError("poses of different lengths are no array")
    return [number for row in rows for number in row]


def shaped(data: bytearray, kind: str, shape: tuple[int, ...]) -> Any:
    """An array on these bytes, which are not copied; `kind` is "d" for doubles, "?" for truth values."""
    if numpy is not None:
        return numpy.frombuffer(data, dtype={"d": numpy.float64, "?": numpy.bool_}[kind]).reshape(shape)
    # A memoryview has no axis of length 0.
    return memoryview(data).cast(kind, shape) if all(shape) else memoryview(data)

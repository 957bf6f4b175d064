"""Undoes the filters of the rows of a PNG."""

from __future__ import annotations

import numpy as np
from numpy.lib.stride_tricks import as_strided

from .picture_header import Picture

_SUB, _UP, _AVERAGE, _PAETH = 1, 2, 3, 4
# Rows at a time, which bounds the memory for their sums.
_BLOCK = 256


def unfiltered(rows: Picture, step: int) -> Picture:
    """The bytes of the pixels, from rows of a filter's number and its bytes; step: bytes of a pixel.

    Raises ValueError for an unknown filter.
    """
    kinds = rows[:, 0]
    if kinds.max() > _PAETH:
        raise ValueError("its data is damaged (unknown filter)")
    result = rows[:, 1:].copy()
    slow = np.flatnonzero(kinds >= _AVERAGE)
    end = len(result) if len(slow) == 0 else int(slow[0])
    _undo_sub_and_up(result[:end], kinds[:end], step)
    if end < len(result):
        _undo_along_diagonals(result, kinds, end, step)
    return result


def _undo_sub_and_up(result: Picture, kinds: Picture, step: int) -> None:
    # Sub needs only its own row, so several of its rows are processed at once; Up continues from the row above.
    sub = np.flatnonzero(kinds == _SUB)
    for start in range(0, len(sub), _BLOCK):
        block = sub[start : start + _BLOCK]
        sums = np.cumsum(result[block].reshape(len(block), -1, step), axis=1, dtype=np.uint8)
        result[block] = sums.reshape(len(block), -1)
    for number in np.flatnonzero(kinds == _UP):
        if number:
            result[number] += result[number - 1]


def _undo_along_diagonals(result: Picture, kinds: Picture, first: int, step: int) -> None:
    """Undoes all filters from a row on. Average and Paeth need the pixels at the left, above, and above at the left, so that pixels
    whose row and column have the same sum are independent of each other: each such diagonal is one step.
    """
    count, width = len(result) - first, result.shape[1] // step
    stride = result.shape[1]
    wanted = kinds[first:, np.newaxis]
    is_sub, is_up, is_average, is_paeth = (wanted == kind for kind in (_SUB, _UP, _AVERAGE, _PAETH))
    # Of the diagonal before and the one before that: pixels by row. Row 0 is the row above the first.
    before, earlier = (np.zeros((count + 1, step), np.int16) for _ in range(2))
    above_first = None if first == 0 else result[first - 1].reshape(width, step)
    for diagonal in range(count + width - 1):
        top, bottom = max(0, diagonal - width + 1), min(count, diagonal + 1)
        # Row y has column diagonal - y here.
        start = (first + top) * stride + (diagonal - top) * step
        pixels = as_strided(result.reshape(-1)[start:], (bottom - top, step), (stride - step, 1))
        if above_first is not None and diagonal < width:
            before[0] = above_first[diagonal]
            earlier[0] = above_first[diagonal - 1] if diagonal else 0
        left, above, corner = before[top + 1 : bottom + 1], before[top:bottom], earlier[top:bottom]
        estimate = left + above - corner
        to_left, to_above, to_corner = abs(estimate - left), abs(estimate - above), abs(estimate - corner)
        nearest = np.where(
            (to_left <= to_above) & (to_left <= to_corner), left, np.where(to_above <= to_corner, above, corner)
        )
        rows = slice(top, bottom)
        average = (left + above) >> 1
        predicted = is_sub[rows] * left + is_up[rows] * above + is_average[rows] * average + is_paeth[rows] * nearest
        pixels += predicted.astype(np.uint8)
        earlier, before = before, earlier
        before[:] = 0
        before[top + 1 : bottom + 1] = pixels

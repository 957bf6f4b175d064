"""The assignment of rows to columns with the greatest sum, by successive shortest paths (the Hungarian method)."""

import numpy as np


def greatest(scores):
    """The pairs of row and column of an assignment with the greatest sum of scores."""
    scores = np.atleast_2d(np.asarray(scores, float))
    if scores.size == 0:
        return []
    if scores.shape[0] > scores.shape[1]:
        return [(row, column) for column, row in greatest(scores.T)]
    costs = scores.max() - scores
    rows, columns = costs.shape
    of_row, of_column = np.zeros(rows + 1), np.zeros(columns + 1)
    row_of = np.full(columns + 1, -1)
    for row in range(rows):
        row_of[columns] = row
        column, previous = columns, np.full(columns, columns)
        shortest, done = np.full(columns, np.inf), np.zeros(columns + 1, bool)
        while row_of[column] != -1:
            done[column] = True
            here, best, step = row_of[column], -1, np.inf
            for other in np.flatnonzero(~done[:columns]):
                reduced = costs[here, other] - of_row[here] - of_column[other]
                if reduced < shortest[other]:
                    shortest[other], previous[other] = reduced, column
                if shortest[other] < step:
                    step, best = shortest[other], other
            for other in range(columns + 1):
                if done[other]:
                    of_row[row_of[other]] += step
                    of_column[other] -= step
                elif other < columns:
                    shortest[other] -= step
            column = best
        while column != columns:
            row_of[column] = row_of[previous[column]]
            column = previous[column]
    return sorted((int(row_of[column]), column) for column in range(columns) if row_of[column] != -1)

namespace Harvester.Geometry.Depth;

/// <summary>Says of a cell whose corners are sampled whether and how it should be divided.</summary>
internal sealed class CellJudge(DepthGrid grid, IReadOnlyDictionary<int, DepthSample> samples)
{
    /// <summary>Depths that differ by less than this fraction agree: 2 cm at 10 m.</summary>
    private const double Tolerance = 0.002;

    /// <summary>Weight of a cell whose surfaces seem to meet in an edge, so that its depths are probably right.</summary>
    private const double EdgeWeight = 0.35;

    private readonly CellSurfaces _surfaces = new();

    /// <summary>How much it matters that a cell is divided; 0 if it need not be.</summary>
    public double WeightOf(DepthCell cell)
    {
        double disagreement = cell.Side > grid.LastSide ? Disagreement(cell) : 0;

        // Expected gain of a division: the cell's pixels times the fraction by which they may be wrong.
        double area = (double)(cell.Right - cell.Left) * (cell.Bottom - cell.Top);
        return disagreement <= Tolerance ? 0 : area * Math.Min(1, disagreement) * (MeetInEdge(cell) ? EdgeWeight : 1);
    }

    /// <summary>
    /// Where to divide a cell: only between left and right, or only between top and bottom, if all that differs is on different sides.
    /// </summary>
    /// <returns>A column and a row; those of the cell's left and top do not divide it.</returns>
    public (int Column, int Row) DivisionOf(DepthCell cell)
    {
        // A change along the upper or lower side separates left from right, one along the left or right side top from bottom. If only one
        // kind occurs, two parts instead of four save rays at upright and level edges.
        bool across = Differ(cell.Left, cell.Top, cell.Right, cell.Top) || Differ(cell.Left, cell.Bottom, cell.Right, cell.Bottom);
        bool along = Differ(cell.Left, cell.Top, cell.Left, cell.Bottom) || Differ(cell.Right, cell.Top, cell.Right, cell.Bottom);
        bool isFlat = cell.Right - cell.Left <= 1 || cell.Bottom - cell.Top <= 1 || across == along;
        return (across || isFlat ? ColumnOf(cell) : cell.Left, along || isFlat ? cell.Middle.Row : cell.Top);
    }

    /// <summary>The column where a neighbouring cell has found a change, beside it; else that of the middle.</summary>
    private int ColumnOf(DepthCell cell)
    {
        int best = cell.Right - cell.Left;
        int column = cell.Middle.Column;
        foreach (int row in new[] { cell.Top, cell.Bottom })
        {
            int last = cell.Left;
            for (int next = cell.Left + 1; next <= cell.Right; next++)
            {
                if (samples.ContainsKey(grid.At(next, row)))
                {
                    // The closest pair of samples that disagree encloses the change most tightly. The division goes through the sample of
                    // the pair that lies inside the cell.
                    if (next - last < best && Differ(last, row, next, row))
                    {
                        (best, column) = (next - last, last > cell.Left ? last : next);
                    }

                    last = next;
                }
            }
        }

        return column;
    }

    /// <summary>By what fraction the samples in a cell disagree within a region of the mask; 1 if a region has none.</summary>
    private double Disagreement(DepthCell cell)
    {
        (int Column, int Row)[] places = samples.ContainsKey(grid.At(cell.Middle.Column, cell.Middle.Row))
            ? [.. cell.Corners, cell.Middle]
            : cell.Corners;
        double greatest = IsCovered(cell, places) ? 0 : 1;
        foreach ((int column, int row) in places)
        {
            DepthSample sample = samples[grid.At(column, row)];
            SightLine line = grid.LineOf(column, row);
            foreach ((int otherColumn, int otherRow) in places)
            {
                greatest = Math.Max(greatest, Deviation(samples[grid.At(otherColumn, otherRow)], sample, line));
            }
        }

        return greatest;
    }

    private bool Differ(int column, int row, int otherColumn, int otherRow)
    {
        DepthSample sample = samples[grid.At(column, row)];
        DepthSample other = samples[grid.At(otherColumn, otherRow)];
        return Deviation(sample, other, grid.LineOf(otherColumn, otherRow)) > Tolerance
            || Deviation(other, sample, grid.LineOf(column, row)) > Tolerance;
    }

    private double Deviation(DepthSample from, DepthSample sample, SightLine line)
    {
        double deviation = Depth.Deviation.Of(from, sample, line);
        return grid.ToleranceMetres is not { } tolerance ? deviation
            : deviation > 0 && deviation * sample.Depth > tolerance ? 1
            : 0;
    }

    private bool MeetInEdge(DepthCell cell)
    {
        _surfaces.Begin(cell);
        (int Column, int Row)[] corners = cell.Corners;
        for (int corner = 0; corner < corners.Length; corner++)
        {
            int at = grid.At(corners[corner].Column, corners[corner].Row);
            _surfaces.Add(corner, at, samples[at], 0, grid.LineAt(at));
        }

        _surfaces.Understand();
        return _surfaces.MeetInEdge;
    }

    private bool IsCovered(DepthCell cell, (int Column, int Row)[] places)
    {
        if (grid.Regions is null)
        {
            return true;
        }

        ushort? last = null;
        for (int row = cell.Top; row <= cell.Bottom; row++)
        {
            for (int column = cell.Left; column <= cell.Right; column++)
            {
                // Neighbouring places are mostly of one region, so only changes along the row are looked up among the samples.
                ushort region = grid.Regions[grid.At(column, row)];
                if (region != last && !Array.Exists(places, place => samples[grid.At(place.Column, place.Row)].Region == region))
                {
                    return false;
                }

                last = region;
            }
        }

        return true;
    }
}

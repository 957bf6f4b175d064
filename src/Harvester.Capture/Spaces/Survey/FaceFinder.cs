using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Capture.Spaces.Survey;

/// <summary>
/// Finds the faces of a sign with a grid of rays: the rows in which the model is wider than its post, in bands of one depth each. The
/// tips of triangles and diamonds are as narrow as a post, so a band goes on over rows whose depth is the plate's. A band before
/// whose plate the post is seen looks to the other side.
/// </summary>
internal sealed class FaceFinder(StageProbe probe, StagedModel model)
{
    /// <summary>Half of it is the error of a straight edge, and all of it that of a tip, metres.</summary>
    private const double FinestStep = 0.012;
    private const double MostRays = 30_000;

    /// <summary>A row is of a face when it is wider than the post by this factor and by so many metres.</summary>
    private const double WiderByFactor = 1.5;
    private const double WiderByMetres = 0.06;

    /// <summary>Rows of one plate differ less in depth than this, metres.</summary>
    private const double SamePlane = 0.02;

    /// <summary>The least distance between a plate's surface and its post's by which they are told apart, metres.</summary>
    private const double PlateOffset = 0.004;

    /// <summary>Lower bands are rims and brackets, metres.</summary>
    private const double LowestFace = 0.08;

    /// <summary>The faces found so far.</summary>
    public List<MeasuredSpace> Faces { get; } = [];

    /// <summary>Measures; each element is a ray or so.</summary>
    public IEnumerable<bool> Run()
    {
        double area = (model.Max.X - model.Min.X) * (model.Max.Z - model.Min.Z);
        var grid = new DepthGrid(
            model.Min.X, model.Min.Z, model.Max.X, model.Max.Z, Math.Max(FinestStep, Math.Sqrt(area / MostRays)));
        foreach (bool ray in grid.Fill(probe))
        {
            yield return ray;
        }

        int[] widths = [.. Enumerable.Range(0, grid.Rows).Select(grid.Width)];
        int[] met = [.. widths.Where(width => width > 0)];
        if (met.Length == 0)
        {
            yield break;
        }

        int post = met.Min();
        bool isWhole = post * WiderByFactor > met.Max();
        double least = isWhole ? 0 : Math.Max(post * WiderByFactor, post + (WiderByMetres / grid.Step));
        foreach ((int first, int last) in Bands(grid, row => widths[row] > least))
        {
            if ((last - first + 1) * grid.Step >= LowestFace)
            {
                Faces.Add(Measure(grid, first, last, isWhole));
            }
        }
    }

    private static List<(int First, int Last)> Bands(DepthGrid grid, Func<int, bool> isWide)
    {
        var bands = new List<(int First, int Last)>();
        for (int row = 0; row < grid.Rows; row++)
        {
            if (!isWide(row))
            {
                continue;
            }

            bool goesOn = bands.Count > 0 && bands[bands.Count - 1].Last == row - 1
                && Math.Abs(grid.MedianDepth(row)!.Value - grid.MedianDepth(row - 1)!.Value) <= SamePlane;
            if (goesOn)
            {
                bands[bands.Count - 1] = (bands[bands.Count - 1].First, row);
            }
            else
            {
                bands.Add((row, row));
            }
        }

        return bands;
    }

    private MeasuredSpace Measure(DepthGrid grid, int first, int last, bool isWhole)
    {
        double plane = grid.MedianDepth((first + last) / 2)!.Value;
        if (!isWhole)
        {
            first = Grow(grid, first, -1, plane);
            last = Grow(grid, last, 1, plane);
        }

        int left = grid.Columns;
        int right = 0;
        for (int row = first; row <= last; row++)
        {
            if (grid.Near(row, plane, SamePlane) is { } span)
            {
                left = Math.Min(left, span.First);
                right = Math.Max(right, span.Last);
            }
        }

        bool looksAhead = HasPostBefore(grid, first, last, plane);
        double back = BackOf(grid, first, last, left, right) ?? plane;
        double y = looksAhead ? back : plane;
        return new MeasuredSpace(
            new(grid.XOf(left), y, grid.ZOf(first)),
            new(grid.XOf(right + 1), y, grid.ZOf(last + 1)),
            looksAhead ? Facing.Front : Facing.Back,
            isWhole);
    }

    /// <summary>The outermost row to which the plate's surface goes on from a row.</summary>
    private static int Grow(DepthGrid grid, int row, int step, double plane)
    {
        int next = row + step;
        while (next >= 0 && next < grid.Rows && grid.Near(next, plane, PlateOffset) is not null)
        {
            row = next;
            next += step;
        }

        return row;
    }

    /// <summary>Whether, seen from behind, something stands before a good part of the plate: its post, which need not reach the upper edge.</summary>
    private static bool HasPostBefore(DepthGrid grid, int first, int last, double plane)
    {
        const int leastShare = 4;
        int before = Enumerable.Range(first, last - first + 1)
            .Count(row => Enumerable.Range(0, grid.Columns).Any(column => grid[column, row] < plane - PlateOffset));
        return before * leastShare > last - first + 1;
    }

    /// <summary>The plate's other side, beside the post.</summary>
    private double? BackOf(DepthGrid grid, int first, int last, int left, int right)
    {
        const double besidePost = 0.8;
        double column = left + (besidePost * (right - left));
        double z = grid.ZOf((first + last + 1) * 0.5);
        return probe.FromAhead(grid.XOf(column), z);
    }
}

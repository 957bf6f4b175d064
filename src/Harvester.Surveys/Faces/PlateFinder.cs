using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Faces;

namespace Harvester.Surveys.Faces;

/// <summary>
/// Measures the plate of a sign from some of its rows: which way it looks, and how far it reaches. Its post stands behind it, so from its
/// face every part of it is seen, also the tips that are narrower than the post.
/// </summary>
internal sealed class PlateFinder(StageProbe probe, DepthGrid grid, SignPost post, int first, int last)
{
    /// <summary>Depths of one plate differ less than this, metres.</summary>
    private const double SamePlane = 0.02;

    /// <summary>The least distance between a plate's surface and its post's by which they are told apart, metres.</summary>
    private const double PlateOffset = 0.004;

    private double _plane;
    private double _beforePost;
    private bool _looksAhead;

    /// <summary>The face; null before the end.</summary>
    public MeasuredFace? Found { get; private set; }

    /// <summary>Measures; each element is a few rays.</summary>
    public IEnumerable<bool> Run()
    {
        int middle = (first + last) / 2;
        double behind = grid.MedianDepth(middle, column => !post.HasColumn(column))!.Value;
        FindSide(middle, behind);
        yield return true;

        (int Column, int Row)[] known = [.. Known(behind, middle)];
        if (known.Length == 0)
        {
            yield break;
        }

        double[] edges = new double[4];
        for (int i = 0; i < edges.Length; i++)
        {
            bool isUpright = i < 2;
            var edge = new EdgeSearch(
                isUpright ? (across, along) =>
                    IsPlate(across, along) : (across, along) => IsPlate(along, across), grid.Step, i % 2 == 0 ? -1 : 1);
            foreach (bool rays in edge.Run(known.Select(cell => isUpright
                ? (grid.XOf(cell.Column + 0.5), grid.ZOf(cell.Row + 0.5))
                : (grid.ZOf(cell.Row + 0.5), grid.XOf(cell.Column + 0.5)))))
            {
                yield return rays;
            }

            edges[i] = edge.Furthest;
        }

        Found = new MeasuredFace(
            new(edges[2], _plane, edges[0]), new(edges[3], _plane, edges[1]), _looksAhead ? Facing.Front : Facing.Back, post.IsWhole);
    }

    /// <summary>A plate behind its post, seen from behind, looks ahead.</summary>
    private void FindSide(int middle, double behind)
    {
        double? nearest = post.IsWhole ? null : post.Columns.Min(column => grid[column, post.Row]);
        _looksAhead = nearest is { } before ? behind > before : HasPostBefore(behind);
        int beside = Enumerable.Range(0, grid.Columns).FirstOrDefault(column => !post.IsNear(column) && IsOn(column, middle, behind));
        _plane = (_looksAhead ? probe.FromAhead(grid.XOf(beside + 0.5), grid.ZOf(middle + 0.5)) : behind) ?? behind;
        double z = grid.ZOf(post.Row + 0.5);
        double? surface = _looksAhead ? post.Columns.Max(column => probe.FromAhead(grid.XOf(column + 0.5), z)) : nearest;
        _beforePost = surface is { } there ? Math.Min(SamePlane, Math.Abs(_plane - there) / 2) : SamePlane;
    }

    /// <summary>Cells that are the plate's: those that the grid has seen, and where the post hid it, those of the middle row.</summary>
    private IEnumerable<(int Column, int Row)> Known(double behind, int middle)
    {
        for (int column = 0; column < grid.Columns; column++)
        {
            if (post.IsNear(column))
            {
                if (IsPlate(grid.XOf(column + 0.5), grid.ZOf(middle + 0.5)))
                {
                    yield return (column, middle);
                }

                continue;
            }

            for (int row = first; row <= last; row++)
            {
                if (IsOn(column, row, behind))
                {
                    yield return (column, row);
                }
            }
        }
    }

    private bool IsOn(int column, int row, double behind) => grid[column, row] is { } depth && Math.Abs(depth - behind) <= SamePlane;

    /// <summary>Whether a ray at the face meets the plate.</summary>
    private bool IsPlate(double x, double z)
    {
        double? depth = _looksAhead ? probe.FromAhead(x, z) : probe.FromBehind(x, z);
        double tolerance = post.IsNear(grid.ColumnOf(x)) ? _beforePost : SamePlane;
        return depth is { } met && Math.Abs(met - _plane) <= tolerance;
    }

    /// <summary>Whether, seen from behind, something stands before a good part of a plate of which no post was found.</summary>
    private bool HasPostBefore(double behind)
    {
        const int leastShare = 4;
        int before = Enumerable.Range(first, last - first + 1)
            .Count(row => Enumerable.Range(0, grid.Columns).Any(column => grid[column, row] < behind - PlateOffset));
        return before * leastShare > last - first + 1;
    }
}

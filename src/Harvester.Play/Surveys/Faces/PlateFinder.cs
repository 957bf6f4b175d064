using Harvester.Geometry.Work;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Measures the plate of a sign from some of its rows: its direction and its extent. Its post stands behind it, so all of it is visible
/// from the front, including tips that are narrower than the post.
/// </summary>
internal sealed class PlateFinder(StageProbe probe, ModelDepths grid, SignPost post, int first, int last)
{
    /// <summary>Maximum difference between the depths of one plate, metres.</summary>
    private const double SamePlane = 0.02;

    /// <summary>Minimum distance between the surfaces of a plate and its post that distinguishes them, metres.</summary>
    private const double PlateOffset = 0.004;

    private double _plane;
    private double _beforePost;
    private bool _looksAhead;

    /// <summary>The face; null before the end.</summary>
    public MeasuredFace? Found { get; private set; }

    /// <summary>Measures the plate.</summary>
    public IEnumerable<WorkStep> Run()
    {
        int middle = (first + last) / 2;
        double behind = grid.MedianDepth(middle, column => !post.HasColumn(column))!.Value;
        FindSide(middle, behind);
        yield return WorkStep.Pause;

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
                isUpright ? (across, along) => IsPlate(across, along) : (across, along) => IsPlate(along, across),
                grid.Step,
                i % 2 == 0 ? -1 : 1
            );
            yield return WorkStep.Do(
                edge.Run(
                    known.Select(cell =>
                        isUpright
                            ? (grid.XOf(cell.Column + 0.5), grid.ZOf(cell.Row + 0.5))
                            : (grid.ZOf(cell.Row + 0.5), grid.XOf(cell.Column + 0.5))
                    )
                )
            );
            edges[i] = edge.End;
        }

        Found = new MeasuredFace(
            new(edges[2], _plane, edges[0]),
            new(edges[3], _plane, edges[1]),
            _looksAhead ? Facing.Front : Facing.Back,
            post.IsWhole
        );
    }

    /// <summary>A plate behind its post, seen from behind, looks forward.</summary>
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

    /// <summary>Cells of the plate: those that the grid has hit and, where the post hid it, those of the middle row.</summary>
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

    /// <summary>Whether a ray at the face hits the plate.</summary>
    private bool IsPlate(double x, double z)
    {
        double? depth = _looksAhead ? probe.FromAhead(x, z) : probe.FromBehind(x, z);
        double tolerance = post.IsNear(grid.ColumnOf(x)) ? _beforePost : SamePlane;
        return depth is { } met && Math.Abs(met - _plane) <= tolerance;
    }

    /// <summary>Whether, seen from behind, something stands in front of a large part of a plate for which no post was found.</summary>
    private bool HasPostBefore(double behind)
    {
        const int minFraction = 4;
        int before = Enumerable
            .Range(first, last - first + 1)
            .Count(row => Enumerable.Range(0, grid.Columns).Any(column => grid[column, row] < behind - PlateOffset));
        return before * minFraction > last - first + 1;
    }
}

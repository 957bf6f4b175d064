using Harvester.Geometry;
using Harvester.Geometry.Work;
using Harvester.Sessions.Faces;

namespace Harvester.Play.Surveys.Faces;

/// <summary>
/// Finds the heads of a traffic light: around each bone that marks one, rays measure the extent of the housing's front, and rays across it
/// measure its depth. The backplate lies deeper and does not count.
/// </summary>
internal sealed class HeadFinder(StageProbe probe, StagedModel model)
{
    private const double Step = 0.012;

    /// <summary>Maximum distance of a head's edge from its bone, metres.</summary>
    private const double Reach = 0.75;

    /// <summary>Maximum distance from its bone at which the front is searched, metres.</summary>
    private const double Core = 0.25;

    /// <summary>Housing and lenses lie within this distance behind the front, the backplate does not, metres.</summary>
    private const double FrontTolerance = 0.06;

    /// <summary>Maximum depth of a housing, metres.</summary>
    private const double MaxHousingDepth = 0.6;

    /// <summary>The heads found so far.</summary>
    public List<MeasuredFace> Heads { get; } = [];

    /// <summary>Measures the model.</summary>
    public IEnumerable<WorkStep> Run()
    {
        foreach (Vector3D bone in model.Heads)
        {
            var grid = new ModelDepths(bone.X - Reach, bone.Z - Reach, bone.X + Reach, bone.Z + Reach, Step);
            yield return WorkStep.Do(grid.Fill(probe));

            if (Measure(grid) is { } head)
            {
                Heads.Add(head);
            }
        }
    }

    private MeasuredFace? Measure(ModelDepths grid)
    {
        int middle = grid.Columns / 2;
        int core = (int)(Core / Step);
        double[] depths =
        [
            .. Cells(grid)
                .Where(cell => Math.Abs(cell.Column - middle) <= core && Math.Abs(cell.Row - middle) <= core)
                .Select(cell => cell.Depth)
                .OrderBy(depth => depth),
        ];
        if (depths.Length == 0)
        {
            return null;
        }

        double front = depths[depths.Length / 2];
        (int Column, int Row, double Depth)[] cells = [.. Cells(grid).Where(cell => cell.Depth <= front + FrontTolerance)];
        double left = grid.XOf(cells.Min(cell => cell.Column));
        double right = grid.XOf(cells.Max(cell => cell.Column) + 1);
        double bottom = grid.ZOf(cells.Min(cell => cell.Row));
        double top = grid.ZOf(cells.Max(cell => cell.Row) + 1);
        return new MeasuredFace(
            new(left, cells.Min(cell => cell.Depth), bottom),
            new(right, BackOf(left, front, (bottom + top) / 2), top),
            Facing.Back,
            false
        );
    }

    /// <summary>The depth from which rays to the right, starting left of the housing, no longer hit it.</summary>
    private double BackOf(double left, double front, double z)
    {
        const double before = 0.02;
        const int steps = (int)(MaxHousingDepth / Step);
        double back = front;
        for (int step = 0; step < steps; step++)
        {
            double y = front + ((step + 0.5) * Step);
            if (probe.ToRight(new Vector3D(left - before, y, z)) is not { } distance || distance > before + Step)
            {
                break;
            }

            back = y + (Step / 2);
        }

        return back;
    }

    private static IEnumerable<(int Column, int Row, double Depth)> Cells(ModelDepths grid) =>
        from row in Enumerable.Range(0, grid.Rows)
        from column in Enumerable.Range(0, grid.Columns)
        where grid[column, row] is not null
        select (column, row, grid[column, row]!.Value);
}

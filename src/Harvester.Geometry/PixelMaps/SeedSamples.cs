using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// The first points to sample: a few in each silhouette, then the corners of the cells from coarse to fine. A corner outside all
/// silhouettes is assumed to show nothing. One between coarser corners of one number is assumed to have that number if everything else
/// there lies behind it, so that an object that fills the image costs few rays. Like every assumed pixel, a corner is sampled if a change
/// of number is found next to it.
/// </summary>
internal sealed class SeedSamples(Camera camera, IReadOnlyList<TargetView> views, PixelSamples samples, CellGrid grid)
{
    /// <summary>Corners this many cells apart are sampled first, then at half the distance, and so on.</summary>
    private const int CoarsestStride = 4;

    /// <summary>The points. Each depends on what was found at those before, so they must be enumerated lazily.</summary>
    public IEnumerable<SubpixelPoint> InTurn()
    {
        foreach (TargetView view in views)
        {
            foreach (SubpixelPoint place in view.SeedSamples())
            {
                yield return place;
            }
        }

        HashSet<(int Column, int Row)> corners = grid.Corners();
        for (int stride = CoarsestStride; stride >= 1; stride /= 2)
        {
            for (int r = 0; r < grid.Rows.Count; r += stride)
            {
                for (int c = 0; c < grid.Columns.Count; c += stride)
                {
                    (int column, int row) = (grid.Columns[c], grid.Rows[r]);
                    if (corners.Contains((column, row)) && !samples.IsKnown(column, row) && !Assume(c, r, stride))
                    {
                        yield return SubpixelPoint.OfPixel(column, row);
                    }
                }
            }
        }
    }

    private bool Assume(int c, int r, int stride)
    {
        (int column, int row) = (grid.Columns[c], grid.Rows[r]);
        List<TargetView> there = [];
        foreach (TargetView view in views)
        {
            if (view.Spans.Contains(column, row))
            {
                there.Add(view);
            }
        }

        if (there.Count == 0)
        {
            samples.Assume(column, row, 0);
            return true;
        }

        if (Around(c, r, stride) is not { } around || !there.TrueForAll(view => view.Target.Number == around.Number || IsBehind(view)))
        {
            return false;
        }

        samples.Assume(column, row, around.Number, around.Farthest);
        return true;

        bool IsBehind(TargetView view) =>
            view.Target.Cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is not { } span || span.Entry > around.Farthest;
    }

    // The number that all coarser corners around a corner share, and the greatest of their distances; null if they differ.
    private (int Number, float Farthest)? Around(int c, int r, int stride)
    {
        // A corner of this stride lies on the grid of twice the stride (0) or halfway between its corners (stride), in each direction.
        int aside = c / stride % 2 * stride;
        int above = r / stride % 2 * stride;
        bool isCoarsest = stride == CoarsestStride;
        if (isCoarsest || c + aside >= grid.Columns.Count || r + above >= grid.Rows.Count)
        {
            return null;
        }

        int? number = null;
        float farthest = 0;
        foreach (
            (int nearC, int nearR) in new[]
            {
                (c - aside, r - above),
                (c + aside, r - above),
                (c - aside, r + above),
                (c + aside, r + above),
            }
        )
        {
            (int column, int row) = (grid.Columns[nearC], grid.Rows[nearR]);
            if (!samples.IsKnown(column, row) || (number ?? samples.Number(column, row)) != samples.Number(column, row))
            {
                return null;
            }

            number = samples.Number(column, row);
            farthest = Math.Max(farthest, samples.Distance(column, row));
        }

        return (number!.Value, farthest);
    }
}

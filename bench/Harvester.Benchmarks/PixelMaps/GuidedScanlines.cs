using Harvester.Geometry.PixelMaps;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// Hull-guided scanlines: rows are asked in the middle and at the ends of every silhouette's span and on a grid between, and changes
/// are found by bisection. Rows between two that show the same numbers are drawn straight; otherwise the row between is asked as well.
/// </summary>
internal static class GuidedScanlines
{
    public static InstanceMap Map(SampledImage image, IReadOnlyList<MapTarget> targets, int rowStep, int columnStep)
    {
        var map = new InstanceMap(image.Size);
        int above = 0;
        Scan(image, map, targets, 0, columnStep);
        for (int row = rowStep; above < image.Size.Height - 1; row += rowStep)
        {
            int below = Math.Min(row, image.Size.Height - 1);
            Scan(image, map, targets, below, columnStep);
            Between(image, map, targets, above, below, columnStep);
            above = below;
        }

        return map;
    }

    private static void Between(SampledImage image, InstanceMap map, IReadOnlyList<MapTarget> targets, int above, int below, int columnStep)
    {
        if (below - above < 2)
        {
            return;
        }

        List<(int Start, ushort Number)> upper = Runs(map, above);
        List<(int Start, ushort Number)> lower = Runs(map, below);
        if (!upper.Select(run => run.Number).SequenceEqual(lower.Select(run => run.Number)))
        {
            int middle = (above + below) / 2;
            Scan(image, map, targets, middle, columnStep);
            Between(image, map, targets, above, middle, columnStep);
            Between(image, map, targets, middle, below, columnStep);
            return;
        }

        for (int row = above + 1; row < below; row++)
        {
            double share = (double)(row - above) / (below - above);
            for (int run = 0; run < upper.Count; run++)
            {
                int start = (int)Math.Round(upper[run].Start + ((lower[run].Start - upper[run].Start) * share));
                for (int column = start; column < image.Size.Width; column++)
                {
                    map[column, row] = upper[run].Number;
                }
            }
        }
    }

    private static List<(int Start, ushort Number)> Runs(InstanceMap map, int row)
    {
        List<(int Start, ushort Number)> runs = [(0, map[0, row])];
        for (int column = 1; column < map.Image.Width; column++)
        {
            if (map[column, row] != map[column - 1, row])
            {
                runs.Add((column, map[column, row]));
            }
        }

        return runs;
    }

    private static void Scan(SampledImage image, InstanceMap map, IReadOnlyList<MapTarget> targets, int row, int columnStep)
    {
        int last = image.Size.Width - 1;
        var columns = new SortedSet<int> { 0, last };
        foreach (MapTarget target in targets)
        {
            if (target.Projection.Box is { } box && row + 0.5 >= box.YMin && row + 0.5 < box.YMax)
            {
                int first = Math.Clamp((int)box.XMin, 0, last);
                int end = Math.Clamp((int)box.XMax, 0, last);
                columns.Add(first);
                columns.Add((first + end) / 2);
                columns.Add(end);
                for (int column = first; column < end; column += columnStep)
                {
                    columns.Add(column);
                }
            }
        }

        int before = 0;
        foreach (int column in columns)
        {
            Bisect(image, row, before, column);
            before = column;
        }

        ushort number = 0;
        for (int column = 0; column <= last; column++)
        {
            number = image.IsKnown(column, row) ? (ushort)image[column, row] : number;
            map[column, row] = number;
        }
    }

    private static void Bisect(SampledImage image, int row, int from, int to)
    {
        if (to - from > 1 && image[from, row] != image[to, row])
        {
            int middle = (from + to) / 2;
            Bisect(image, row, from, middle);
            Bisect(image, row, middle, to);
        }
    }
}

using Harvester.Datasets.Exports.Masks;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Tests.Exports.Masks;

/// <summary>Run lengths and outlines of drawn shapes: # is the object, o another one.</summary>
public sealed class MaskShapeTests
{
    [Theory]
    // Column by column, outside first: the single pixel in column 1, row 1 of 3 x 3 comes after 4 others, and 4 follow.
    [InlineData("...|.#.|...", "4,1,4")]
    [InlineData("###|###|###", "0,9")]
    // Columns: .#, ##, .. -> 1 outside, 3 inside across the column's end, 2 outside.
    [InlineData(".#.|##.", "1,3,2")]
    [InlineData("#o|#o", "0,2,2")]
    [InlineData("..#", "2,1")]
    // The lower pixel of the first column and the upper of the second touch in the order of the columns.
    [InlineData(".#|#.", "1,2,1")]
    public void RunLengths_run_down_the_columns(string drawing, string expected) =>
        Assert.Equal(expected, string.Join(',', RunLengths.Of(Pixels(drawing))));

    [Theory]
    [InlineData("...|.#.|...", "1,1 2,1 2,2 1,2")]
    [InlineData("##.|##.", "0,0 2,0 2,2 0,2")]
    [InlineData("#.|##", "0,0 1,0 1,1 2,1 2,2 0,2")]
    // Two pixels that meet in a corner hang together by no side.
    [InlineData("#.|.#", "0,0 1,0 1,1 0,1;1,1 2,1 2,2 1,2")]
    [InlineData(".#|#.", "1,0 2,0 2,1 1,1;0,1 1,1 1,2 0,2")]
    // A hole is filled.
    [InlineData("###|#.#|###", "0,0 3,0 3,3 0,3")]
    [InlineData("#.##", "2,0 4,0 4,1 2,1;0,0 1,0 1,1 0,1")]
    public void Outlines_run_along_the_borders_of_pixels(string drawing, string expected) =>
        Assert.Equal(expected, string.Join(';', Outlines.Of(Pixels(drawing)).Select(outline => string.Join(' ', outline.Select(corner => $"{corner.X},{corner.Y}")))));

    [Fact]
    public void Run_lengths_and_outlines_of_random_masks_give_the_pixels_back()
    {
        var random = new Random(4);
        for (int trial = 0; trial < 200; trial++)
        {
            var map = new InstanceMap(new ImageSize(random.Next(1, 12), random.Next(1, 12)));
            for (int i = 0; i < map.Ids.Length; i++)
            {
                map.Ids[i] = (ushort)random.Next(0, 3);
            }

            foreach (InstancePixels pixels in InstancePixels.AllOf(map).Values)
            {
                AssertRunsGiveBack(map, pixels);
                AssertOutlinesHold(map, pixels);
            }
        }
    }

    private static void AssertRunsGiveBack(InstanceMap map, InstancePixels pixels)
    {
        int at = 0;
        bool inside = false;
        foreach (int count in RunLengths.Of(pixels))
        {
            for (int end = at + count; at < end; at++)
            {
                Assert.Equal(inside, map[at / map.Image.Height, at % map.Image.Height] == pixels.Id);
            }

            inside = !inside;
        }

        Assert.Equal(map.Ids.Length, at);
        Assert.Equal(pixels.Area, map.Ids.Count(id => id == pixels.Id));
    }

    /// <summary>Every pixel of the object lies in an outline, and every other pixel in one is fenced in by the object: no walk by sides leads out.</summary>
    private static void AssertOutlinesHold(InstanceMap map, InstancePixels pixels)
    {
        IReadOnlyList<IReadOnlyList<Vector2D>> outlines = Outlines.Of(pixels);
        bool[,] outside = Outside(map, pixels.Id);
        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < map.Image.Width; column++)
            {
                bool covered = outlines.Any(outline => IsInside(outline, column + 0.5, row + 0.5));
                Assert.Equal(!outside[column + 1, row + 1], covered);
            }
        }
    }

    /// <summary>The pixels from which one gets out of the image without crossing the object, corners included, with a margin of one pixel.</summary>
    private static bool[,] Outside(InstanceMap map, ushort id)
    {
        var outside = new bool[map.Image.Width + 2, map.Image.Height + 2];
        var open = new Stack<(int X, int Y)>([(0, 0)]);
        while (open.TryPop(out (int X, int Y) at))
        {
            bool isOff = at.X < 0 || at.Y < 0 || at.X >= map.Image.Width + 2 || at.Y >= map.Image.Height + 2;
            if (isOff || outside[at.X, at.Y] || (at.X >= 1 && at.Y >= 1 && at.X <= map.Image.Width && at.Y <= map.Image.Height && map[at.X - 1, at.Y - 1] == id))
            {
                continue;
            }

            outside[at.X, at.Y] = true;
            for (int dy = -1; dy <= 1; dy++)
            {
                for (int dx = -1; dx <= 1; dx++)
                {
                    open.Push((at.X + dx, at.Y + dy));
                }
            }
        }

        return outside;
    }

    private static bool IsInside(IReadOnlyList<Vector2D> outline, double x, double y)
    {
        bool inside = false;
        for (int i = 0; i < outline.Count; i++)
        {
            Vector2D a = outline[i];
            Vector2D b = outline[(i + 1) % outline.Count];
            if ((a.Y > y) != (b.Y > y) && x < a.X + ((b.X - a.X) * (y - a.Y) / (b.Y - a.Y)))
            {
                inside = !inside;
            }
        }

        return inside;
    }

    private static InstancePixels Pixels(string drawing)
    {
        string[] rows = drawing.Split('|');
        var map = new InstanceMap(new ImageSize(rows[0].Length, rows.Length));
        for (int row = 0; row < rows.Length; row++)
        {
            for (int column = 0; column < rows[row].Length; column++)
            {
                map[column, row] = (ushort)(rows[row][column] switch { '#' => 7, 'o' => 8, _ => 0 });
            }
        }

        return InstancePixels.AllOf(map)[7];
    }
}

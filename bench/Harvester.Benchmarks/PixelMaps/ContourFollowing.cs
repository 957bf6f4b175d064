using Harvester.Geometry.PixelMaps;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// Boundary tracing: between neighbouring pixels of a grid that differ, or a seed and the grid lines beside it, a change is found by
/// bisection, and the outline through it is followed pixel by pixel until it closes or leaves the image. Between outlines rows are filled
/// from the left.
/// </summary>
internal static class ContourFollowing
{
    private static readonly (int X, int Y)[] Steps = [(1, 0), (0, 1), (-1, 0), (0, -1)];

    public static InstanceMap Map(SampledImage image, int gridSize)
    {
        var followed = new HashSet<(int, int, int)>();
        for (int row = 0; row < image.Size.Height; row += gridSize)
        {
            for (int column = 0; column < image.Size.Width; column += gridSize)
            {
                Search(image, followed, column, row, Math.Min(column + gridSize, image.Size.Width - 1), row);
                Search(image, followed, column, row, column, Math.Min(row + gridSize, image.Size.Height - 1));
            }
        }

        foreach ((int column, int row) in image.Seeds)
        {
            Search(image, followed, column / gridSize * gridSize, row, column, row);
            Search(image, followed, column, row, Math.Min(column + gridSize, image.Size.Width - 1), row);
            Search(image, followed, column, row / gridSize * gridSize, column, row);
            Search(image, followed, column, row, column, Math.Min(row + gridSize, image.Size.Height - 1));
        }

        return image.FillFromTheLeft();
    }

    private static void Search(SampledImage image, HashSet<(int, int, int)> followed, int x0, int y0, int x1, int y1)
    {
        if (image[x0, y0] == image[x1, y1])
        {
            return;
        }

        while (Math.Abs(x1 - x0) + Math.Abs(y1 - y0) > 1)
        {
            int x = (x0 + x1) / 2;
            int y = (y0 + y1) / 2;
            if (image[x, y] == image[x0, y0])
            {
                (x0, y0) = (x, y);
            }
            else
            {
                (x1, y1) = (x, y);
            }
        }

        Follow(image, followed, x0, y0, x1 > x0 ? 0 : 1);
        Follow(image, followed, x1, y1, x1 > x0 ? 2 : 3);
    }

    // The pixel keeps its outline on the side of a direction; the walk turns around it with the outline always on that side.
    private static void Follow(SampledImage image, HashSet<(int, int, int)> followed, int x, int y, int side)
    {
        int number = image[x, y];
        while (followed.Add((x, y, side)))
        {
            int ahead = (side + 3) % 4;
            (int X, int Y) next = (x + Steps[ahead].X, y + Steps[ahead].Y);
            (int X, int Y) beyond = (next.X + Steps[side].X, next.Y + Steps[side].Y);
            if (!Shows(image, next, number))
            {
                side = ahead;
            }
            else if (Shows(image, beyond, number))
            {
                (x, y) = beyond;
                side = (side + 1) % 4;
            }
            else
            {
                (x, y) = next;
            }
        }
    }

    private static bool Shows(SampledImage image, (int X, int Y) pixel, int number) =>
        pixel.X >= 0 && pixel.Y >= 0 && pixel.X < image.Size.Width && pixel.Y < image.Size.Height && image[pixel.X, pixel.Y] == number;
}

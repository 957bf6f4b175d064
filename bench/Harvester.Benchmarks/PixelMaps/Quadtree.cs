using Harvester.Geometry.PixelMaps;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>The plain quadtree: a cell whose corners differ is divided, down to the pixel; one whose corners agree is filled.</summary>
internal static class Quadtree
{
    public static InstanceMap Map(SampledImage image, int cellSize)
    {
        var map = new InstanceMap(image.Size);
        for (int top = 0; top < image.Size.Height; top += cellSize)
        {
            for (int left = 0; left < image.Size.Width; left += cellSize)
            {
                Fill(
                    image, map, left, top,
                    Math.Min(left + cellSize, image.Size.Width - 1), Math.Min(top + cellSize, image.Size.Height - 1));
            }
        }

        return map;
    }

    private static void Fill(SampledImage image, InstanceMap map, int left, int top, int right, int bottom)
    {
        int number = image[left, top];
        bool isUniform = image[right, top] == number && image[left, bottom] == number && image[right, bottom] == number;
        if (isUniform || (right - left <= 1 && bottom - top <= 1))
        {
            for (int row = top; row <= bottom; row++)
            {
                for (int column = left; column <= right; column++)
                {
                    map[column, row] = (ushort)(image.IsKnown(column, row) ? image[column, row] : number);
                }
            }

            return;
        }

        int x = (left + right) / 2;
        int y = (top + bottom) / 2;
        Fill(image, map, left, top, Math.Max(x, left), Math.Max(y, top));
        Fill(image, map, x, top, right, y);
        Fill(image, map, left, y, x, bottom);
        Fill(image, map, x, y, right, bottom);
    }
}

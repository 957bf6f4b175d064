using Harvester.Geometry.PixelMaps;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>
/// The plain quadtree: a cell whose corners and seeds differ is divided, down to a least size; one that agrees is filled.
/// </summary>
internal static class Quadtree
{
    public static InstanceMap Map(SampledImage image, int cellSize, int minSize)
    {
        var map = new InstanceMap(image.Size);
        for (int top = 0; top < image.Size.Height; top += cellSize)
        {
            for (int left = 0; left < image.Size.Width; left += cellSize)
            {
                Fill(
                    image,
                    map,
                    minSize,
                    left,
                    top,
                    Math.Min(left + cellSize, image.Size.Width - 1),
                    Math.Min(top + cellSize, image.Size.Height - 1)
                );
            }
        }

        return map;
    }

    private static void Fill(SampledImage image, InstanceMap map, int minSize, int left, int top, int right, int bottom)
    {
        int number = image[left, top];
        bool isUniform =
            image[right, top] == number
            && image[left, bottom] == number
            && image[right, bottom] == number
            && image.Seeds.All(seed =>
                seed.Column < left || seed.Column > right || seed.Row < top || seed.Row > bottom || image[seed.Column, seed.Row] == number
            );
        if (isUniform || (right - left <= minSize && bottom - top <= minSize))
        {
            for (int row = top; row <= bottom; row++)
            {
                for (int column = left; column <= right; column++)
                {
                    map[column, row] = (ushort)(
                        image.IsKnown(column, row)
                            ? image[column, row]
                            : image[column - left < right - column ? left : right, row - top < bottom - row ? top : bottom]
                    );
                }
            }

            return;
        }

        int x = (left + right) / 2;
        int y = (top + bottom) / 2;
        Fill(image, map, minSize, left, top, Math.Max(x, left), Math.Max(y, top));
        Fill(image, map, minSize, x, top, right, y);
        Fill(image, map, minSize, left, y, x, bottom);
        Fill(image, map, minSize, x, y, right, bottom);
    }
}

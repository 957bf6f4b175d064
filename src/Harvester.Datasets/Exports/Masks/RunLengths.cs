using System.Collections.Generic;

namespace Harvester.Datasets.Exports.Masks;

/// <summary>COCO's uncompressed run lengths: column by column from the upper left, by turns pixels outside and inside the object, outside first.</summary>
internal static class RunLengths
{
    public static IReadOnlyList<int> Of(InstancePixels pixels)
    {
        var counts = new List<int>();
        int height = pixels.Map.Image.Height;
        int runStart = 0;
        bool isInside = false;
        for (int column = pixels.Left; column < pixels.Right; column++)
        {
            for (int row = pixels.Top; row < pixels.Bottom; row++)
            {
                Turn((column * height) + row, pixels.Contains(column, row));
            }

            // Below the object comes the next column's top; only one as high as the image goes on there.
            if (pixels.Bottom - pixels.Top < height)
            {
                Turn((column * height) + pixels.Bottom, false);
            }
        }

        int end = height * pixels.Map.Image.Width;
        Turn(pixels.Right * height, false);
        if (runStart < end)
        {
            counts.Add(end - runStart);
        }

        return counts;

        void Turn(int at, bool inside)
        {
            if (inside != isInside)
            {
                counts.Add(at - runStart);
                runStart = at;
                isInside = inside;
            }
        }
    }
}

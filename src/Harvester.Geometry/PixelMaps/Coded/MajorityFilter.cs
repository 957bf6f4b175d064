namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// Where two objects have the same colour, noise decides which is in front. A pixel among pixels of another object goes to that object, if
/// it is there too.
/// </summary>
internal static class MajorityFilter
{
    /// <summary>More than half of a pixel's eight neighbours.</summary>
    private const int Majority = 5;
    private const int Rounds = 3;

    /// <summary>Gives pixels among those of another object to that object, a few rounds.</summary>
    /// <param name="map">The map.</param>
    /// <param name="isThere">Whether an object is in a pixel, visible or not: its number, the column and the row.</param>
    public static void Apply(InstanceMap map, Func<ushort, int, int, bool> isThere)
    {
        for (int round = 0; round < Rounds; round++)
        {
            ushort[] before = (ushort[])map.Ids.Clone();
            for (int row = 1; row < map.Image.Height - 1; row++)
            {
                for (int column = 1; column < map.Image.Width - 1; column++)
                {
                    int pixel = (row * map.Image.Width) + column;

                    // One candidate is enough: five of eight neighbours seldom leave out both the left and the upper one.
                    ushort other = before[pixel - 1] != before[pixel] ? before[pixel - 1] : before[pixel - map.Image.Width];
                    if (
                        before[pixel] != 0
                        && other != 0
                        && other != before[pixel]
                        && CountAround(before, map.Image.Width, pixel, other) >= Majority
                        && isThere(other, column, row)
                    )
                    {
                        map.Ids[pixel] = other;
                    }
                }
            }
        }
    }

    /// <summary>The number of pixels among one inside the image and its eight neighbours that have a number.</summary>
    public static int CountAround(ushort[] ids, int width, int pixel, ushort number)
    {
        int count = 0;
        for (int down = -width; down <= width; down += width)
        {
            for (int across = -1; across <= 1; across++)
            {
                count += ids[pixel + down + across] == number ? 1 : 0;
            }
        }

        return count;
    }
}

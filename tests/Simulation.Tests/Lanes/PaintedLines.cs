using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Lanes;

/// <summary>Finds painted lines in a picture by their colour, at noon in clear weather: paint is far brighter than asphalt, yellow paint has little blue.</summary>
internal sealed class PaintedLines(RenderTarget picture)
{
    /// <summary>How far paint is looked for to either side of where it should be, in pixels of the picture.</summary>
    private const int Reach = 24;

    /// <summary>How far along the line paint counts, in pixels of the picture.</summary>
    private const double AlongReach = 2;

    private const int FewestPixels = 4;

    /// <summary>The distance from a line to the middle of the paint beside it.</summary>
    /// <param name="at">Where the line is expected, pixels.</param>
    /// <param name="along">Unit vector along the line in the picture.</param>
    /// <returns>Pixels across the line, positive to its right; null where there is no paint, as in the gap of a dashed line.</returns>
    public double? OffsetOfPaint(Vector2D at, Vector2D along)
    {
        double sum = 0;
        double sumAlong = 0;
        int count = 0;
        for (int row = (int)at.Y - Reach; row <= (int)at.Y + Reach; row++)
        {
            for (int column = (int)at.X - Reach; column <= (int)at.X + Reach; column++)
            {
                if (!IsPaint(column, row))
                {
                    continue;
                }

                Vector2D apart = new Vector2D(column + 0.5, row + 0.5) - at;
                if (Math.Abs(apart.Dot(along)) <= AlongReach && Math.Abs(along.Cross(apart)) <= Reach)
                {
                    sum += along.Cross(apart);
                    sumAlong += along.Dot(apart);
                    count++;
                }
            }
        }

        // At the slanted end of a dash the middle of the paint is not the middle of the line.
        return count >= FewestPixels && Math.Abs(sumAlong / count) < AlongReach / 8 ? sum / count : null;
    }

    private bool IsPaint(int column, int row)
    {
        if (column < 0 || row < 0 || column >= picture.Width || row >= picture.Height)
        {
            return false;
        }

        int index = ((row * picture.Width) + column) * 3;
        (byte red, byte green, byte blue) = (picture.Colour[index], picture.Colour[index + 1], picture.Colour[index + 2]);
        bool isWhite = Math.Min(red, Math.Min(green, blue)) > 175;
        bool isYellow = red > 150 && red - blue > 60;
        return picture.Handles[((row * picture.Width) + column)] == 0 && (isWhite || isYellow);
    }
}

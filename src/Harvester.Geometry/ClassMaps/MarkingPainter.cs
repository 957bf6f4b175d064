using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.ClassMaps;

/// <summary>Draws known painted lines into a class map, where the map shows road.</summary>
/// <param name="camera">The camera.</param>
/// <param name="map">The map.</param>
/// <param name="road">Its class of roads.</param>
/// <param name="marking">Its class of markings.</param>
public sealed class MarkingPainter(Camera camera, InstanceMap map, ushort road, ushort marking)
{
    /// <summary>A pixel shows a marking if it covers at least half of it: of this many by this many places.</summary>
    private const int Places = 4;
    private const int Half = Places * Places / 2;

    /// <summary>Points farther apart do not belong to one piece of paint, metres.</summary>
    private const double MaxStep = 2;

    /// <summary>A double line is two stripes, each a third of its width, with a gap of a third between them.</summary>
    private const double Third = 1.0 / 3;

    private readonly Dictionary<int, byte> _covered = [];

    /// <summary>Draws the painted pieces of lines at their width.</summary>
    /// <param name="lines">The lines, whose points are on the road.</param>
    /// <param name="endMetres">How far paint continues beyond its last point before a gap, metres: half the points' distance.</param>
    public void Paint(IEnumerable<PaintedLine> lines, double endMetres)
    {
        foreach (PaintedLine line in Guard.NotNull(lines, nameof(lines)))
        {
            double width = line.Paint.WidthMetres;
            bool isDouble = line.Paint.Style == MarkingStyle.DoubleSolid;
            for (int i = 0; i + 1 < line.Points.Count; i++)
            {
                (LinePoint a, LinePoint b) = (line.Points[i], line.Points[i + 1]);
                Vector3D step = b.World - a.World;
                if (!a.IsPainted || !b.IsPainted || !(step.Length is > 0 and <= MaxStep))
                {
                    continue;
                }

                Vector3D along = step.Normalized();
                Vector3D from = i > 0 && !line.Points[i - 1].IsPainted ? a.World - (along * endMetres) : a.World;
                Vector3D to = i + 2 < line.Points.Count && !line.Points[i + 2].IsPainted ? b.World + (along * endMetres) : b.World;

                // Each piece of paint is a quadrilateral on the road: half of the width to either side of its line.
                Vector3D right = along.Cross(new Vector3D(0, 0, 1)).Normalized();
                if (isDouble)
                {
                    Cover(from, to, right * (-width / 2), right * (-width / 2 * Third));
                    Cover(from, to, right * (width / 2 * Third), right * (width / 2));
                }
                else
                {
                    Cover(from, to, right * (-width / 2), right * (width / 2));
                }
            }
        }

        foreach (KeyValuePair<int, byte> pixel in _covered)
        {
            if (pixel.Value >= Half && map.Ids[pixel.Key] == road)
            {
                map.Ids[pixel.Key] = marking;
            }
        }

        _covered.Clear();
    }

    private void Cover(Vector3D from, Vector3D to, Vector3D left, Vector3D right)
    {
        Vector3D[] corners = [from + left, from + right, to + right, to + left];
        var pixels = new Vector2D[corners.Length];
        double top = double.PositiveInfinity;
        double bottom = double.NegativeInfinity;
        double first = double.PositiveInfinity;
        double last = double.NegativeInfinity;
        for (int i = 0; i < corners.Length; i++)
        {
            Projection projection = camera.Project(corners[i]);
            if (projection.Outcome == ProjectionOutcome.BehindNearPlane)
            {
                return;
            }

            pixels[i] = new Vector2D(projection.U, projection.V);
            (first, last) = (Math.Min(first, projection.U), Math.Max(last, projection.U));
            (top, bottom) = (Math.Min(top, projection.V), Math.Max(bottom, projection.V));
        }

        (int fromColumn, int toColumn) = Range(first, last, map.Image.Width);
        (int fromRow, int toRow) = Range(top, bottom, map.Image.Height);
        for (int row = fromRow; row <= toRow; row++)
        {
            for (int column = fromColumn; column <= toColumn; column++)
            {
                if (map[column, row] == road)
                {
                    Count(pixels, column, row);
                }
            }
        }
    }

    private void Count(Vector2D[] corners, int column, int row)
    {
        int inside = 0;
        for (int place = 0; place < Places * Places; place++)
        {
            // Centres of a grid of Places x Places within the pixel.
            var at = new Vector2D(column + (((place % Places) + 0.5) / Places), row + (((place / Places) + 0.5) / Places));
            inside += IsInside(corners, at) ? 1 : 0;
        }

        if (inside > 0)
        {
            int index = (row * map.Image.Width) + column;
            _covered.TryGetValue(index, out byte before);
            _covered[index] = (byte)Math.Min(byte.MaxValue, before + inside);
        }
    }

    private static bool IsInside(Vector2D[] corners, Vector2D place)
    {
        int positive = 0;
        int negative = 0;
        for (int i = 0; i < corners.Length; i++)
        {
            // Inside a convex quadrilateral all cross products of side and place have one sign, whichever way round it is.
            double side = (corners[(i + 1) % corners.Length] - corners[i]).Cross(place - corners[i]);
            positive += side > 0 ? 1 : 0;
            negative += side < 0 ? 1 : 0;
        }

        return positive == 0 || negative == 0;
    }

    private static (int From, int To) Range(double low, double high, int length) =>
        ((int)Math.Max(0, Math.Floor(low)), (int)Math.Min(length - 1, Math.Floor(high)));
}

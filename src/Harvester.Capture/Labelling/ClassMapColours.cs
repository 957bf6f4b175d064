using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Completes a class map from rays with the colours of the picture: outlines between surfaces move to the edges of colours next to them,
/// and paint that no one reports, such as crossings and stop lines, is found as what is as bright on the road as known paint.
/// </summary>
internal static class ClassMapColours
{
    /// <summary>How far an outline drawn between rays may be off, pixels.</summary>
    private const int Reach = 2;

    /// <summary>The colours of both sides are taken from this many pixels around.</summary>
    private const int Window = 4;

    /// <summary>Least squared distance between the mean colours of two distinguishable sides, square grey levels.</summary>
    private const double MinContrast = 24 * 24;

    /// <summary>How much nearer a pixel must be to the other side's colour than to its own: fraction of the squared distance.</summary>
    private const double Clearly = 0.4;

    /// <summary>The rank of the road's own brightness among the pixels around; more than half of them may be paint.</summary>
    private const double RoadRank = 0.25;

    /// <summary>Paint is at least so much brighter than the road: a factor and grey levels.</summary>
    private const double MinBrightness = 1.25;
    private const double MinStep = 12;

    /// <summary>Fewer pixels of known paint do not show how bright paint is.</summary>
    private const int MinKnown = 30;

    /// <summary>Moves outlines to the edges of colours near them, then finds paint on roads.</summary>
    public static void Complete(InstanceMap map, InstanceMap? mask, PixelBuffer picture)
    {
        MoveOutlines(map, mask, picture);
        FindPaint(map, mask, picture);
    }

    private static void MoveOutlines(InstanceMap map, InstanceMap? mask, PixelBuffer picture)
    {
        int width = map.Image.Width;
        ushort[] before = (ushort[])map.Ids.Clone();
        for (int row = 0; row < map.Image.Height; row++)
        {
            for (int column = 0; column < width; column++)
            {
                int at = (row * width) + column;
                if (IsSurface(before[at], mask, at) && OtherNear(before, mask, map, column, row) is { } other)
                {
                    map.Ids[at] = NearerOf(before, mask, map, picture, (column, row), before[at], other);
                }
            }
        }
    }

    /// <summary>Objects are as the mask shows them, and paint is thinner than outlines are exact.</summary>
    private static bool IsSurface(ushort value, InstanceMap? mask, int at) =>
        (mask is null || mask.Ids[at] == 0) && value < (ushort)SemanticClass.Car && value != (ushort)SemanticClass.LaneMarking;

    private static ushort? OtherNear(ushort[] classes, InstanceMap? mask, InstanceMap map, int column, int row)
    {
        ushort own = classes[(row * map.Image.Width) + column];
        for (int distance = 1; distance <= Reach; distance++)
        {
            foreach ((int x, int y) in new[] { (distance, 0), (-distance, 0), (0, distance), (0, -distance) })
            {
                int at = ((row + y) * map.Image.Width) + column + x;
                if (
                    column + x >= 0
                    && column + x < map.Image.Width
                    && row + y >= 0
                    && row + y < map.Image.Height
                    && classes[at] != own
                    && IsSurface(classes[at], mask, at)
                )
                {
                    return classes[at];
                }
            }
        }

        return null;
    }

    private static ushort NearerOf(
        ushort[] classes,
        InstanceMap? mask,
        InstanceMap map,
        PixelBuffer picture,
        (int Column, int Row) place,
        ushort own,
        ushort other
    )
    {
        var ownColour = default(MeanColour);
        var otherColour = default(MeanColour);
        for (int row = Math.Max(0, place.Row - Window); row <= Math.Min(map.Image.Height - 1, place.Row + Window); row++)
        {
            for (int column = Math.Max(0, place.Column - Window); column <= Math.Min(map.Image.Width - 1, place.Column + Window); column++)
            {
                int at = (row * map.Image.Width) + column;
                if (mask is not null && mask.Ids[at] != 0)
                {
                    continue;
                }

                if (classes[at] == own)
                {
                    ownColour.Add(picture.Bytes, at);
                }
                else if (classes[at] == other)
                {
                    otherColour.Add(picture.Bytes, at);
                }
            }
        }

        int pixel = (place.Row * map.Image.Width) + place.Column;
        return
            // The pixel changes sides if the colours can be distinguished and its own is clearly nearer to the other one.
            ownColour.SquaredTo(otherColour) >= MinContrast
            && otherColour.SquaredTo(picture.Bytes, pixel) < Clearly * ownColour.SquaredTo(picture.Bytes, pixel)
            ? other
            : own;
    }

    private static void FindPaint(InstanceMap map, InstanceMap? mask, PixelBuffer picture)
    {
        var roads = new RoadBrightness(map, picture, RoadRank);
        double factor = KnownBrightness(map, roads, picture) ?? 0;
        ushort[] before = (ushort[])map.Ids.Clone();
        for (int row = 1; row < map.Image.Height - 1; row++)
        {
            for (int column = 1; column < map.Image.Width - 1; column++)
            {
                int at = (row * map.Image.Width) + column;
                if (
                    before[at] == (ushort)SemanticClass.Road
                    && roads.Near(column, row) is { } road
                    && RoadBrightness.Of(picture.Bytes, at) > Math.Max((road * MinBrightness) + MinStep, road * factor)
                    && IsOnRoad(before, mask, map, at)
                )
                {
                    map.Ids[at] = (ushort)SemanticClass.LaneMarking;
                }
            }
        }
    }

    /// <summary>The brightness halfway between the road and the paint on it that is known, relative to the road's.</summary>
    private static double? KnownBrightness(InstanceMap map, RoadBrightness roads, PixelBuffer picture)
    {
        List<double> factors = [];
        for (int at = 0; at < map.Ids.Length; at++)
        {
            if (
                map.Ids[at] == (ushort)SemanticClass.LaneMarking
                && roads.Near(at % map.Image.Width, at / map.Image.Width) is > 0 and { } road
            )
            {
                factors.Add(RoadBrightness.Of(picture.Bytes, at) / road);
            }
        }

        if (factors.Count < MinKnown)
        {
            return null;
        }

        factors.Sort();

        // The third quartile of known paint: much of it is worn, or drawn beside where it is by a pixel.
        return (1 + factors[factors.Count * 3 / 4]) / 2;
    }

    /// <summary>Whether a pixel and those around it are road: the edge of something bright beside the road is no paint.</summary>
    private static bool IsOnRoad(ushort[] classes, InstanceMap? mask, InstanceMap map, int at)
    {
        for (int y = -1; y <= 1; y++)
        {
            for (int x = -1; x <= 1; x++)
            {
                int other = at + (y * map.Image.Width) + x;
                if (
                    classes[other] is not ((ushort)SemanticClass.Road or (ushort)SemanticClass.LaneMarking)
                    || (mask is not null && mask.Ids[other] != 0)
                )
                {
                    return false;
                }
            }
        }

        return true;
    }
}

using Harvester.Geometry;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>
/// The part of the world that the map of a log shows, in whole metres. Its lower left corner is the origin of the log's global frame.
/// </summary>
/// <param name="West">Least x in the world, metres.</param>
/// <param name="South">Least y in the world, metres.</param>
/// <param name="East">Greatest x in the world, metres.</param>
/// <param name="North">Greatest y in the world, metres.</param>
internal sealed record NuScenesArea(int West, int South, int East, int North)
{
    /// <summary>What is added to a position in the world, metres.</summary>
    public Vector3D Offset => new(-West, -South, 0);

    /// <summary>Width, metres.</summary>
    public int Width => East - West;

    /// <summary>Height, metres.</summary>
    public int Height => North - South;

    /// <summary>The square around a place.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="margin">Distance of its sides from the place, metres.</param>
    public static NuScenesArea Around(Vector3D place, double margin) =>
        new(
            (int)Math.Floor(place.X - margin),
            (int)Math.Floor(place.Y - margin),
            (int)Math.Ceiling(place.X + margin),
            (int)Math.Ceiling(place.Y + margin)
        );

    /// <summary>The least area that has all of the given ones.</summary>
    public static NuScenesArea Of(IEnumerable<NuScenesArea> areas) =>
        areas.Aggregate(
            (one, other) =>
                new NuScenesArea(
                    Math.Min(one.West, other.West),
                    Math.Min(one.South, other.South),
                    Math.Max(one.East, other.East),
                    Math.Max(one.North, other.North)
                )
        );

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static NuScenesArea Parse(string text)
    {
        int[] sides = [.. Numbers.Parse(text.Split(' '))!.Select(side => (int)side)];
        return new NuScenesArea(sides[0], sides[1], sides[2], sides[3]);
    }

    /// <summary>The area as four numbers: west, south, east, north.</summary>
    public override string ToString() => FormattableString.Invariant($"{West} {South} {East} {North}");
}

using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>The fields of records of a nuScenes map as text without semicolons.</summary>
internal static class ExpansionText
{
    /// <summary>Between the fields of a record.</summary>
    public const char Field = '|';

    private const char Item = ',';
    private const int MetreDecimals = 3;

    /// <summary>Points on the ground, metres, to a millimetre.</summary>
    public static string Of(IReadOnlyList<Vector2D> points) =>
        Numbers.Row(MetreDecimals, [.. points.SelectMany(point => (double[])[point.X, point.Y])]);

    /// <summary>Names without commas.</summary>
    public static string Of(IEnumerable<string> names) => string.Join(Item, names);

    /// <summary>Reads points.</summary>
    public static Vector2D[] Points(string text) => [.. Values(text).Chunk(2).Select(point => new Vector2D(point[0], point[1]))];

    /// <summary>Reads numbers.</summary>
    public static double[] Values(string text) => text.Length == 0 ? [] : Numbers.Parse(text.Split(' '))!;

    /// <summary>Reads names.</summary>
    public static string[] Names(string text) => text.Length == 0 ? [] : text.Split(Item);
}

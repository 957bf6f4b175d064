using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>A light or sign of a nuScenes map.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Position">Metres, world.</param>
/// <param name="Facing">The direction on the ground in which it looks.</param>
/// <param name="Lanes">The names of the lanes that it governs.</param>
internal sealed record ExpansionSignal(string Id, MapSignalKind Kind, Vector3D Position, Vector2D Facing, IReadOnlyList<string> Lanes)
{
    /// <summary>Begins the text of a signal.</summary>
    public const string Prefix = "#signal";

    private const int Decimals = 6;

    /// <summary>A signal of a map.</summary>
    public static ExpansionSignal Of(MapSignal signal) =>
        new(
            signal.Id,
            signal.Kind,
            signal.Position,
            new Vector2D(signal.Facing.X, signal.Facing.Y),
            [.. signal.Lanes.Select(lane => lane.Id)]
        );

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static ExpansionSignal Parse(string text)
    {
        string[] fields = text.Split(ExpansionText.Field);
        double[] numbers = ExpansionText.Values(fields[2]);
        return new ExpansionSignal(
            fields[1],
            (MapSignalKind)(int)numbers[0],
            new Vector3D(numbers[1], numbers[2], numbers[3]),
            new Vector2D(numbers[4], numbers[5]),
            ExpansionText.Names(fields[3])
        );
    }

    /// <summary>The signal as a line of text without semicolons.</summary>
    public override string ToString() =>
        string.Join(
            ExpansionText.Field,
            Prefix,
            Id,
            Numbers.Row(Decimals, (int)Kind, Position.X, Position.Y, Position.Z, Facing.X, Facing.Y),
            ExpansionText.Of(Lanes)
        );
}

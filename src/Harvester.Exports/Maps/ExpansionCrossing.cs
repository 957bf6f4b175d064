using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>A pedestrian crossing of a nuScenes map. Metres on the ground, world.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Corners">Its outline.</param>
/// <param name="Road">The name of the road or junction below it; empty if there is none.</param>
internal sealed record ExpansionCrossing(string Id, IReadOnlyList<Vector2D> Corners, string Road)
{
    /// <summary>Begins the text of a crossing.</summary>
    public const string Prefix = "#crossing";

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static ExpansionCrossing Parse(string text)
    {
        string[] fields = text.Split(ExpansionText.Field);
        return new ExpansionCrossing(fields[1], ExpansionText.Points(fields[2]), fields[3]);
    }

    /// <summary>The crossing as a line of text without semicolons.</summary>
    public override string ToString() => string.Join(ExpansionText.Field, Prefix, Id, ExpansionText.Of(Corners), Road);
}

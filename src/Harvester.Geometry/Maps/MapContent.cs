using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;

namespace Harvester.Geometry.Maps;

/// <summary>What a map has beside its roads.</summary>
public sealed record MapContent
{
    /// <summary>Nothing.</summary>
    public static MapContent None { get; } = new();

    /// <summary>The traffic lights and the signs.</summary>
    public IReadOnlyList<MapProp> Props { get; init; } = [];

    /// <summary>The signs with speed limits.</summary>
    public IReadOnlyList<MapSpeedSign> SpeedSigns { get; init; } = [];

    /// <summary>The paint measured on the map's network; null if there is none.</summary>
    public PaintTable? Paint { get; init; }

    /// <summary>Lines that are known exactly; they take precedence over measured ones.</summary>
    public IReadOnlyList<PaintedLine> KnownLines { get; init; } = [];

    /// <summary>Stop lines and crossings that are known exactly.</summary>
    public IReadOnlyList<PaintedMark> KnownMarks { get; init; } = [];
}

using Harvester.Datasets.Logs;
using Harvester.Geometry;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>A part of the map around a frame, by names that are the same in every frame of a session.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Type">As in <see cref="LogFeature"/>.</param>
/// <param name="Points">Metres, world.</param>
internal sealed record NamedFeature(string Name, LogFeatureKind Kind, int Type, IReadOnlyList<Vector3D> Points)
{
    /// <summary>Of a lane, those that lead into it.</summary>
    public IReadOnlyList<string> Entries { get; init; } = [];

    /// <summary>Of a lane, those that continue it.</summary>
    public IReadOnlyList<string> Exits { get; init; } = [];

    /// <summary>Of a lane, that on its left in the same direction.</summary>
    public IReadOnlyList<string> Left { get; init; } = [];

    /// <summary>Of a lane, that on its right in the same direction.</summary>
    public IReadOnlyList<string> Right { get; init; } = [];

    /// <summary>Of a lane, the lines and edges along its left; those that no frame has are left out.</summary>
    public IReadOnlyList<string> LeftLines { get; init; } = [];

    /// <summary>Of a lane, the lines and edges along its right; those that no frame has are left out.</summary>
    public IReadOnlyList<string> RightLines { get; init; } = [];

    /// <summary>Whether a lane leads through a junction.</summary>
    public bool IsWay { get; init; }

    /// <summary>Of a stop sign, the lanes that it governs.</summary>
    public IReadOnlyList<string> Lanes { get; init; } = [];

    /// <summary>
    /// The feature with what the map around another frame says of it: at the border of a map, lanes lack some that lead into them or
    /// continue them, and paint is seen from some frames only.
    /// </summary>
    public NamedFeature With(NamedFeature other) =>
        this with
        {
            Type = Type == 0 ? other.Type : Type,
            Entries = [.. Entries.Union(other.Entries)],
            Exits = [.. Exits.Union(other.Exits)],
            Left = [.. Left.Union(other.Left)],
            Right = [.. Right.Union(other.Right)],
            LeftLines = [.. LeftLines.Union(other.LeftLines)],
            RightLines = [.. RightLines.Union(other.RightLines)],
            Lanes = [.. Lanes.Union(other.Lanes)],
        };
}

using System.Text.Json;

namespace Harvester.Exports.Formats.Columns;

/// <summary>A row of a table, before its columns are taken.</summary>
/// <param name="Frame">The frame.</param>
/// <param name="Parts">The parts of the label that the row is made of; an undefined one is missing in the label.</param>
internal readonly record struct TableRow(TableFrame Frame, params JsonElement[] Parts)
{
    /// <summary>Number of the thing that the row belongs to: an object's id, or a line's number in its frame.</summary>
    public int Owner { get; init; }

    /// <summary>Number of the row among those of its owner, or of its frame.</summary>
    public int Number { get; init; }

    /// <summary>A text that the label has not: a class as the dataset names it, or a kind.</summary>
    public string? Word { get; init; }
}

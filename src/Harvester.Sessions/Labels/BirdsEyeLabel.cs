namespace Harvester.Sessions.Labels;

/// <summary>The bird's-eye map of a frame. File format: docs/birds-eye.md.</summary>
/// <param name="File">Path of the map of classes within the session, with forward slashes.</param>
/// <param name="Visible">Path of the map of cells that the camera sees; null if that is unknown.</param>
/// <param name="Cells">Number of cells along a side, which are the pixels of the maps.</param>
/// <param name="CellMetres">The side of a cell, metres.</param>
/// <param name="Source">Where the ground comes from.</param>
public sealed record BirdsEyeLabel(string File, string? Visible, int Cells, double CellMetres, BirdsEyeSource Source) : IChannelLabel
{
    /// <summary>The value of a cell that the camera sees; others are 0.</summary>
    public const byte Seen = 255;

    /// <inheritdoc />
    public IEnumerable<string> Files => Visible is null ? [File] : [File, Visible];
}

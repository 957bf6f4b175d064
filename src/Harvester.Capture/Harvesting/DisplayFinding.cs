namespace Harvester.Capture.Harvesting;

/// <summary>The comparison of frozen pictures with and without the game's own display.</summary>
/// <param name="State">What became of the display.</param>
/// <param name="Region">Its place in the picture; null unless it can be hidden.</param>
public sealed record DisplayFinding(DisplayState State, string? Region);

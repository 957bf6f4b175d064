namespace Harvester.Exports;

/// <summary>The parts of a frame to export.</summary>
/// <param name="Objects">The objects, by ascending id.</param>
/// <param name="Ignored">The ignore regions.</param>
internal sealed record FrameSelection(IReadOnlyList<ExportObject> Objects, IReadOnlyList<ExportRegion> Ignored);

namespace Harvester.Datasets.Masks;

/// <summary>The result of an import of masks.</summary>
/// <param name="Frames">Number of frames with imported masks.</param>
/// <param name="Objects">Number of labelled objects in them.</param>
/// <param name="Seen">Number of these with visible pixels.</param>
public sealed record MaskImport(int Frames, int Objects, int Seen)
{
    /// <summary>Number of pixels whose value matches no object; they show nothing after the import.</summary>
    public long DroppedPixels { get; init; }

    /// <summary>Number of the first frame with such pixels; null if there is none.</summary>
    public int? FirstFrameWithDropped { get; init; }

    /// <summary>The values of these pixels in that frame, ascending.</summary>
    public IReadOnlyList<int> FirstDroppedValues { get; init; } = [];

    /// <summary>Folder of the session as it was before the import, if it could not be deleted; otherwise null.</summary>
    public string? Leftover { get; init; }
}

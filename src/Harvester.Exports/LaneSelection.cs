namespace Harvester.Exports;

/// <summary>The lane lines of a frame, in formats with a choice.</summary>
public enum LaneSelection
{
    /// <summary>The nearest, at most as many as the benchmark's evaluation expects.</summary>
    Nearest,

    /// <summary>All in the image.</summary>
    All,
}

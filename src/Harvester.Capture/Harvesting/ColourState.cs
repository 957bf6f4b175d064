namespace Harvester.Capture.Harvesting;

/// <summary>What becomes of known colours in pictures.</summary>
public enum ColourState
{
    /// <summary>They come back as they were drawn.</summary>
    Kept,

    /// <summary>Bright ones come back as white, as with HDR.</summary>
    Clipped,

    /// <summary>They come back as other colours.</summary>
    Changed,
}

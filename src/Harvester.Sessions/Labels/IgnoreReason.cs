namespace Harvester.Sessions.Labels;

/// <summary>Why a region of an image is marked instead of labelled.</summary>
public enum IgnoreReason
{
    /// <summary>An object is seen there that lies beyond the labelling range.</summary>
    BeyondRange,

    /// <summary>An object may be seen there: whether it is could not be determined.</summary>
    Undetermined,
}

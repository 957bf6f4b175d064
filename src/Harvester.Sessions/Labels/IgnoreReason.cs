namespace Harvester.Sessions.Labels;

/// <summary>Why a region of an image is marked instead of labelled.</summary>
public enum IgnoreReason
{
    /// <summary>An object beyond the labelling range is visible there.</summary>
    BeyondRange,

    /// <summary>An object may be visible there; this could not be determined.</summary>
    Undetermined,
}

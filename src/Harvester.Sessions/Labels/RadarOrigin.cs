namespace Harvester.Sessions.Labels;

/// <summary>What a detection of a radar comes from. Its number is that of the label.</summary>
public enum RadarOrigin
{
    /// <summary>A surface in its place.</summary>
    Target = 0,

    /// <summary>An object that is seen a second time, elsewhere.</summary>
    Ghost = 1,

    /// <summary>Nothing.</summary>
    Clutter = 2,
}

namespace Harvester.Play.Settings;

/// <summary>The masks of a harvest in the ini.</summary>
internal enum MaskChoice
{
    /// <summary>No masks.</summary>
    Off,

    /// <summary>Masks from rays; the value of earlier versions.</summary>
    On,

    /// <summary>Masks from rays.</summary>
    Rays,

    /// <summary>Masks from photographs in which objects are hidden in turn.</summary>
    Coded,

    /// <summary>Masks from photographs, compared with those from rays.</summary>
    Both,
}

namespace Harvester.Capture.Labelling;

/// <summary>How the instance masks of a frame are made.</summary>
public enum MaskMethod
{
    /// <summary>By rays, which meet the game's collision hulls.</summary>
    Rays,

    /// <summary>By photographs of the frozen world in which objects are hidden in turn.</summary>
    Coded,

    /// <summary>By photographs; masks by rays are made too and compared with them.</summary>
    Both,
}

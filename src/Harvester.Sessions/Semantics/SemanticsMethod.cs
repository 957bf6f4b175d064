namespace Harvester.Sessions.Semantics;

/// <summary>Where the classes of a class map come from.</summary>
public enum SemanticsMethod
{
    /// <summary>From the materials that rays report, and the picture.</summary>
    Rays,

    /// <summary>From the renderer of a simulated game.</summary>
    Exact,
}

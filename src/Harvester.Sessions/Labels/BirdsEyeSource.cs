namespace Harvester.Sessions.Labels;

/// <summary>Where the ground of a bird's-eye map comes from.</summary>
public enum BirdsEyeSource
{
    /// <summary>The geometry of the simulated game, exactly.</summary>
    Exact,

    /// <summary>The known roads and the measured paint.</summary>
    Roads,
}

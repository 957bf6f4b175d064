namespace Harvester.Datasets.Roads.Sources;

/// <summary>Direction of the "lanes in" of a link in paths.ipl and paths.xml; its "lanes out" have the opposite direction.</summary>
public enum LanesIn
{
    /// <summary>From the link's first node to its second, as in DeepGTAV.</summary>
    Forward,

    /// <summary>From the link's second node to its first.</summary>
    Backward,
}

namespace Harvester.Datasets.Roads.Sources;

/// <summary>Which way the "lanes in" of a link in paths.ipl and paths.xml are driven; its "lanes out" are driven the other way.</summary>
public enum LanesIn
{
    /// <summary>From the link's first node to its second: the reading of DeepGTAV.</summary>
    Forward,

    /// <summary>From the link's second node to its first.</summary>
    Backward,
}

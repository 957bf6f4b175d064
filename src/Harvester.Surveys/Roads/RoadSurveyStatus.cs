namespace Harvester.Surveys.Roads;

/// <summary>The progress of a road survey.</summary>
/// <param name="Nodes">Number of nodes found.</param>
/// <param name="Links">Number of links found.</param>
/// <param name="Edges">Number of points found on the edges of links.</param>
/// <param name="Waiting">Nodes whose links, and links whose edges, were not yet asked for.</param>
/// <param name="IsLoaded">Whether the game had the nodes around loaded; until it has, nothing is found.</param>
public readonly record struct RoadSurveyStatus(int Nodes, int Links, int Edges, int Waiting, bool IsLoaded)
{
    /// <summary>How much is known in all; it grows with every finding.</summary>
    public int Findings => Nodes + Links + Edges;
}

namespace Harvester.Surveys.Roads;

/// <summary>How far a survey is.</summary>
/// <param name="Nodes">Nodes known.</param>
/// <param name="Links">Links known.</param>
/// <param name="Edges">Points known on edges of links.</param>
/// <param name="Waiting">Nodes whose links, and links whose edges, were not yet asked for.</param>
/// <param name="IsLoaded">Whether the game had the nodes around loaded; until it has, nothing is found.</param>
public readonly record struct RoadSurveyStatus(int Nodes, int Links, int Edges, int Waiting, bool IsLoaded)
{
    /// <summary>How much is known in all; it grows with every finding.</summary>
    public int Findings => Nodes + Links + Edges;
}

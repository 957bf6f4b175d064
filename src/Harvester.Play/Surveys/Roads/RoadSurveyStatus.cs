namespace Harvester.Play.Surveys.Roads;

/// <summary>The progress of a road survey.</summary>
/// <param name="Nodes">Number of nodes found.</param>
/// <param name="Links">Number of links found.</param>
/// <param name="Edges">Number of points found on the edges of links.</param>
/// <param name="Waiting">Nodes whose links, and links whose edges, were not surveyed yet.</param>
/// <param name="IsLoaded">Whether the game had the nodes around the car loaded; until then nothing is found.</param>
public readonly record struct RoadSurveyStatus(int Nodes, int Links, int Edges, int Waiting, bool IsLoaded)
{
    /// <summary>Number of findings in total; it grows with each one.</summary>
    public int Findings => Nodes + Links + Edges;
}

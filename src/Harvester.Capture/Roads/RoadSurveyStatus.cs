namespace Harvester.Capture.Roads;

/// <summary>How far a survey is.</summary>
/// <param name="Nodes">Nodes known.</param>
/// <param name="Links">Links known.</param>
/// <param name="Waiting">Nodes that are known but whose links were not looked for yet.</param>
/// <param name="IsLoaded">Whether the game had the nodes around loaded; until it has, nothing is found.</param>
public readonly record struct RoadSurveyStatus(int Nodes, int Links, int Waiting, bool IsLoaded);

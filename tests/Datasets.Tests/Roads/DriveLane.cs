namespace Harvester.Datasets.Tests.Roads;

/// <summary>A lane of a link in a direction: 0 the leftmost.</summary>
internal readonly record struct DriveLane(int Link, bool IsForward, int Lane);

namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A position of the JSON dump, metres, truncated as the game stores it.</summary>
internal readonly record struct DumpPosition(double X, double Y, double Z);

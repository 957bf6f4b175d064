namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A position of the JSON dump, metres, truncated as in the game's files.</summary>
internal readonly record struct DumpPosition(double X, double Y, double Z);

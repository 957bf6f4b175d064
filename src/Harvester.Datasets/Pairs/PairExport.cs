namespace Harvester.Datasets.Pairs;

/// <summary>What was exported.</summary>
/// <param name="Groups">Number of moments.</param>
/// <param name="Images">Number of pictures, those of frames included.</param>
/// <param name="Missing">Number of pictures that the harvest dropped.</param>
public sealed record PairExport(int Groups, int Images, int Missing);

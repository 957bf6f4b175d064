namespace Harvester.Exports.Pairs;

/// <summary>What was exported.</summary>
/// <param name="Groups">Number of moments.</param>
/// <param name="Images">Number of pictures, those of frames included.</param>
/// <param name="Missing">Number of pictures that the harvest dropped.</param>
public sealed record PairExport(int Groups, int Images, int Missing)
{
    /// <summary>This and one more moment.</summary>
    internal PairExport With(PairGroup group) =>
        new(Groups + 1, Images + group.Images.Count, Missing + group.Line.Label!.Pairs.Count(pair => pair.File is null));
}

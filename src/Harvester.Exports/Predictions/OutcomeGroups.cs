using Harvester.Datasets.Detections;
using Harvester.Exports.Formats.Kitti;

namespace Harvester.Exports.Predictions;

/// <summary>Matches, misses and false positives, counted by class, size, distance and occlusion.</summary>
/// <param name="classes">Names of the classes.</param>
public sealed class OutcomeGroups(IEnumerable<string> classes)
{
    private static readonly double[] DistanceEnds = [10, 20, 40, 60, 80, double.PositiveInfinity];

    /// <summary>By class.</summary>
    public IReadOnlyList<OutcomeCount> Classes { get; } = [.. classes.Select(name => new OutcomeCount(name))];

    /// <summary>By COCO's ranges of areas; that of a false positive is the area of its box.</summary>
    public IReadOnlyList<OutcomeCount> Sizes { get; } =
    [new("small, up to 32² px"), new("medium, up to 96² px"), new("large, above 96² px")];

    /// <summary>By distance; a false positive has none.</summary>
    public IReadOnlyList<OutcomeCount> Distances { get; } =
    [new("up to 10 m"), new("10 to 20 m"), new("20 to 40 m"), new("40 to 60 m"), new("60 to 80 m"), new("above 80 m")];

    /// <summary>By KITTI's levels of occlusion; a false positive has none.</summary>
    public IReadOnlyList<OutcomeCount> Occlusions { get; } =
    [new("up to 10 % hidden"), new("10 to 50 % hidden"), new("more than 50 % hidden"), new("not determined")];

    /// <summary>All of them.</summary>
    public OutcomeCount All { get; } = new("all");

    internal void Add(FrameOutcome frame)
    {
        foreach (TruthObject item in frame.Found)
        {
            Count(item, count => count.Matches++);
        }

        foreach (TruthObject item in frame.Missed)
        {
            Count(item, count => count.Misses++);
        }

        foreach (PredictionOutcome item in frame.Predictions.Where(item => item.Kind == OutcomeKind.False))
        {
            All.FalsePositives++;
            Classes[item.Box.Class].FalsePositives++;
            Sizes[SizeOf(item.Box.Box.Area)].FalsePositives++;
        }
    }

    private void Count(TruthObject item, Action<OutcomeCount> add)
    {
        add(All);
        add(Classes[item.Box.Class]);
        add(Sizes[SizeOf(item.Box.Area)]);
        if (item.Label is { } label)
        {
            add(Distances[Array.FindIndex(DistanceEnds, end => label.DistanceMetres <= end)]);
            add(Occlusions[KittiClasses.OcclusionOf(label)]);
        }
    }

    /// <summary>The first range above "all" that has an area.</summary>
    private static int SizeOf(double area) => SizeRange.Coco.Skip(1).TakeWhile(range => !range.Has(area)).Count();
}

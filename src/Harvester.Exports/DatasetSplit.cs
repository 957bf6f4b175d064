namespace Harvester.Exports;

/// <summary>A split of a dataset, such as train.</summary>
/// <param name="Name">Name of the split: letters, digits, - and _.</param>
/// <param name="ShareFraction">Fraction of the frames, greater than 0 and at most 1.</param>
public readonly record struct DatasetSplit(string Name, double ShareFraction);

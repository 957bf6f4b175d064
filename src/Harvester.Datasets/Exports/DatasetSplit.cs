namespace Harvester.Datasets.Exports;

/// <summary>A share of the frames that is kept apart, such as train.</summary>
/// <param name="Name">Its name: letters, digits, - and _.</param>
/// <param name="ShareFraction">Its share of the frames, greater than 0 and at most 1.</param>
public readonly record struct DatasetSplit(string Name, double ShareFraction);

namespace Harvester.Datasets.Exports;

/// <summary>How many objects of a frame a writer has written.</summary>
/// <param name="Objects">As objects.</param>
/// <param name="Ignored">As regions that an evaluation leaves aside.</param>
public readonly record struct WrittenObjects(int Objects, int Ignored = 0);

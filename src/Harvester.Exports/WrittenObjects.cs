namespace Harvester.Exports;

/// <summary>Number of objects of a frame that a writer wrote.</summary>
/// <param name="Objects">Number of objects.</param>
/// <param name="Ignored">Number of ignore regions.</param>
public readonly record struct WrittenObjects(int Objects, int Ignored = 0);

namespace Harvester.Datasets.Roads.Ynd;

/// <summary>A link as a cell stores it, before the node where it leads is known.</summary>
internal readonly record struct YndLink(int From, int ToArea, int ToNumber, int Bits, string Place);

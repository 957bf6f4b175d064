namespace Harvester.Datasets.Roads.Ynd;

/// <summary>A link of a cell, before its end node is known.</summary>
internal readonly record struct YndLink(int From, int ToArea, int ToNumber, int Bits, string Place);

using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>A class of a dataset.</summary>
/// <param name="Number">Its place among the dataset's classes, from 0.</param>
/// <param name="Category">A number that does not depend on which other classes are exported: that of the first of the project's classes in
/// it, from 1; for a subclass that · 1000 and its place.</param>
/// <param name="Name">Its name.</param>
/// <param name="Kind">The first of the project's classes in it.</param>
internal sealed record DatasetClass(int Number, int Category, string Name, ObjectClass Kind);

using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>A class of a dataset.</summary>
/// <param name="Number">Index among the dataset's classes, from 0.</param>
/// <param name="Category">An id that does not depend on which other classes are exported: the number, from 1, of the first of the project's
/// classes in it; for a subclass, that number · 1000 plus its index.</param>
/// <param name="Name">Name of the class.</param>
/// <param name="Kind">The first of the project's classes in it.</param>
internal sealed record DatasetClass(int Number, int Category, string Name, ObjectClass Kind);

using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports;

/// <summary>An object of a frame as a dataset has it.</summary>
/// <param name="Label">Its label in the session.</param>
/// <param name="Class">Its class in the dataset.</param>
/// <param name="Box">The box that is exported, pixels.</param>
internal sealed record ExportObject(ObjectLabel Label, DatasetClass Class, Box2D Box);

using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>
/// An ignore region: an object that a filter removed, whose visibility was not determined, or that the session did not label. A detector is
/// neither expected to find it nor penalised for finding it.
/// </summary>
/// <param name="Kind">What it shows.</param>
/// <param name="Class">That as a class of the dataset; null when it is not one of them.</param>
/// <param name="Box">The region, pixels.</param>
/// <param name="Label">The label of what it shows; null without one.</param>
internal sealed record ExportRegion(ObjectClass Kind, DatasetClass? Class, Box2D Box, ObjectLabel? Label);

using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>
/// An ignore region: an object that a filter removed, whose visibility is unknown, or that the session did not label. A detector is neither
/// expected to find it nor penalised for finding it.
/// </summary>
/// <param name="Kind">Class of the object.</param>
/// <param name="Class">Its class in the dataset; null if that class is not exported.</param>
/// <param name="Box">The region, pixels.</param>
/// <param name="Label">The label of the object; null without one.</param>
internal sealed record ExportRegion(ObjectClass Kind, DatasetClass? Class, Box2D Box, ObjectLabel? Label);

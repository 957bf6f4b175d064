using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports;

/// <summary>An object of a frame, as exported.</summary>
/// <param name="Label">The label in the session.</param>
/// <param name="Class">The class in the dataset.</param>
/// <param name="Box">The exported 2D box, pixels.</param>
internal sealed record ExportObject(ObjectLabel Label, DatasetClass Class, Box2D Box);

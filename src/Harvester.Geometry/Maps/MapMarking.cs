using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Maps;

/// <summary>The line painted along most of a lane's edge.</summary>
/// <param name="Paint">How it is painted.</param>
/// <param name="Source">Measured or known.</param>
public sealed record MapMarking(MarkingPaint Paint, MapSource Source);

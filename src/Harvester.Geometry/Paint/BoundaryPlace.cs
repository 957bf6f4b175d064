namespace Harvester.Geometry.Paint;

/// <summary>A place of a lane's boundary.</summary>
/// <param name="Station">Metres along the road.</param>
/// <param name="Offset">Metres to the right of the road's line in the direction of travel.</param>
internal readonly record struct BoundaryPlace(double Station, double Offset);

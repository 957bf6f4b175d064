namespace Harvester.Geometry.Grids;

/// <summary>What a face of the ground is. The numbers are those of bird's-eye maps.</summary>
public enum GroundKind : byte
{
    /// <summary>Ground that is not for driving, or nothing known.</summary>
    Other = 0,

    /// <summary>The surface of a road.</summary>
    Drivable = 1,

    /// <summary>A lane of a road outside junctions, on a drivable surface.</summary>
    Lane = 2,

    /// <summary>Paint, a surface a little above the road's.</summary>
    Line = 3,

    /// <summary>The area of a pedestrian crossing, on a drivable surface.</summary>
    Crossing = 4,
}

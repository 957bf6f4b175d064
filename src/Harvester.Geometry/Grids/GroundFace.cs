namespace Harvester.Geometry.Grids;

/// <summary>A triangle of the ground.</summary>
/// <param name="Kind">
/// What it is. Lanes and crossings are areas on drivable surfaces, with about their height; the others are surfaces, of which the highest
/// counts.
/// </param>
/// <param name="A">First corner, metres, world.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner.</param>
public readonly record struct GroundFace(GroundKind Kind, Vector3D A, Vector3D B, Vector3D C)
{
    /// <summary>Whether it is an area on a surface instead of being one.</summary>
    internal bool IsOnSurface => Kind is GroundKind.Lane or GroundKind.Crossing;
}

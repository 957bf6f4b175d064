using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>The horizontal line perpendicular to a road at one of its points.</summary>
/// <param name="Centre">The point on the road's line, metres, world.</param>
/// <param name="Right">Horizontal unit vector to the right.</param>
internal readonly record struct CrossSection(Vector3D Centre, Vector3D Right)
{
    /// <summary>The point at an offset to the right of the road's line, metres.</summary>
    public Vector3D At(double rightOffset) => Centre + (Right * rightOffset);
}

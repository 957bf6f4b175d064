using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Tests.Scenes;

/// <summary>Something solid of convex parts, with the cuboid around it in its own frame.</summary>
/// <param name="Entity">Handle; 0 if it is not an entity.</param>
/// <param name="Bounds">The cuboid around all parts.</param>
/// <param name="Parts">The parts.</param>
internal sealed record SolidThing(int Entity, Cuboid Bounds, IReadOnlyList<ConvexSolid> Parts)
{
    /// <summary>Builds a thing from parts in its frame: minimum and maximum corner, and the shares to which its top is drawn in.</summary>
    public static SolidThing Build(int entity, Pose pose, params (Vector3D Min, Vector3D Max, double TopWidth, double TopLength)[] parts)
    {
        Vector3D min = parts.Select(p => p.Min).Aggregate((a, b) => new(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z)));
        Vector3D max = parts.Select(p => p.Max).Aggregate((a, b) => new(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z)));
        return new SolidThing(
            entity,
            Cuboid.FromModel(min, max, pose),
            [.. parts.Select(p => ConvexSolid.Frustum(Cuboid.FromModel(p.Min, p.Max, pose), p.TopWidth, p.TopLength))]
        );
    }
}

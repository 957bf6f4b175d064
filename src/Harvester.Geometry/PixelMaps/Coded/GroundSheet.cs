using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>
/// A flat sheet of one bright colour that is drawn in the world for one picture, just above the ground under an object. Where the picture
/// shows its colour, the ground is seen; where the object is seen, it stays. So an object is separated from its shadow and its reflection
/// on the ground, which change with it like the object itself.
/// </summary>
/// <param name="A">A corner, world frame, metres.</param>
/// <param name="B">The next corner.</param>
/// <param name="C">The corner opposite the first.</param>
/// <param name="D">The last corner.</param>
public sealed record GroundSheet(Vector3D A, Vector3D B, Vector3D C, Vector3D D)
{
    /// <summary>The sheet reaches beyond the object's box by so much, metres: as far as the shadows that touch it in the image.</summary>
    private const double MarginMetres = 0.3;

    /// <summary>
    /// It lies so high above the lower end of the box, metres, that the ground does not cover it; it hides that much of wheels.
    /// </summary>
    private const double LiftMetres = 0.04;

    /// <summary>The colour of sheets: magenta, each channel 0 to 255.</summary>
    public static Vector3D Colour { get; } = new(255, 0, 255);

    /// <summary>The sheet under a target.</summary>
    public static GroundSheet Under(MapTarget target)
    {
        Cuboid cuboid = Guard.NotNull(target, nameof(target)).Cuboid;
        Vector3D middle = cuboid.Centre + (cuboid.Axes.Up * (LiftMetres - cuboid.HalfExtents.Z));
        Vector3D right = cuboid.Axes.Right * (cuboid.HalfExtents.X + MarginMetres);
        Vector3D forward = cuboid.Axes.Forward * (cuboid.HalfExtents.Y + MarginMetres);
        return new GroundSheet(middle - right - forward, middle + right - forward, middle + right + forward, middle - right + forward);
    }

    /// <summary>The sheets under targets.</summary>
    public static IReadOnlyList<GroundSheet> Under(IEnumerable<MapTarget> targets) => [.. targets.Select(Under)];

    /// <summary>Whether a ray meets the sheet.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="border">Width of the border that does not count, metres.</param>
    internal bool IsMet(Ray ray, double border = 0)
    {
        Vector3D right = B - A;
        Vector3D forward = D - A;
        Vector3D up = right.Cross(forward);
        double descent = -ray.Direction.Dot(up);
        double distance = (ray.Origin - A).Dot(up) / descent;
        if (descent <= 0 || !(distance > 0))
        {
            return false;
        }

        Vector3D place = ray.Origin + (ray.Direction * distance) - A;
        double across = place.Dot(right) / right.Dot(right);
        double along = place.Dot(forward) / forward.Dot(forward);
        double side = border / right.Length;
        double end = border / forward.Length;
        return across >= side && across <= 1 - side && along >= end && along <= 1 - end;
    }
}

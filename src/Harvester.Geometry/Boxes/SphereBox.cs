using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>The box around the projections of spheres.</summary>
public static class SphereBox
{
    /// <summary>
    /// The box around the outlines of spheres, which need not be in the image. It is exact for a pinhole camera: the sides are where planes
    /// through the camera touch a sphere. Lens distortion moves each side as the point of the outline at the height of the centre.
    /// </summary>
    /// <param name="camera">The camera.</param>
    /// <param name="centres">Metres, world.</param>
    /// <param name="radii">Metres, greater than 0; as many.</param>
    /// <returns>Pixels; null if there is no sphere, or a sphere reaches the near plane.</returns>
    public static Box2D? Around(Camera camera, IReadOnlyList<Vector3D> centres, IReadOnlyList<double> radii)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(centres, nameof(centres));
        Guard.NotNull(radii, nameof(radii));
        Box2D? box = null;
        for (int i = 0; i < centres.Count; i++)
        {
            Vector3D centre = camera.Pose.ToLocal(centres[i]);
            if (centre.Y - radii[i] <= camera.Intrinsics.NearClip)
            {
                return null;
            }

            Box2D around = Around(camera, centre, radii[i]);
            box = box?.Union(around) ?? around;
        }

        return box;
    }

    private static Box2D Around(Camera camera, Vector3D centre, double radius)
    {
        (double left, double right) = Tangents(centre.X, centre.Y, radius);
        (double low, double high) = Tangents(centre.Z, centre.Y, radius);
        return new Box2D(
            camera.PixelOf(centre with { X = left * centre.Y }).X,
            camera.PixelOf(centre with { Z = high * centre.Y }).Y,
            camera.PixelOf(centre with { X = right * centre.Y }).X,
            camera.PixelOf(centre with { Z = low * centre.Y }).Y
        );
    }

    /// <summary>The slopes of the two lines through the origin that touch a circle.</summary>
    private static (double Low, double High) Tangents(double aside, double depth, double radius)
    {
        // Seen in the plane of one image axis, the sphere is a circle at the angle direction and distance d; tangents through the eye are
        // asin(radius / d) to either side of it.
        double direction = Math.Atan2(aside, depth);
        double half = Math.Asin(radius / Math.Sqrt((aside * aside) + (depth * depth)));
        return (Math.Tan(direction - half), Math.Tan(direction + half));
    }
}

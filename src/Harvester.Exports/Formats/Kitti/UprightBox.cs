using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>
/// A cuboid as an upright box in the camera's frame (x right, y down, z forward), the only kind that KITTI can represent. Size, depth and
/// rotation are the cuboid's. The box is shifted in x and y so that its projection has the same centre as the cuboid's, which minimises the
/// largest error of the projected sides.
/// </summary>
internal sealed record UprightBox
{
    private const int MaxSteps = 40;
    private const int Corners = 8;

    /// <summary>A thousandth of the last decimal of KITTI's pixels.</summary>
    private const double MinStepPixels = 0.00001;

    /// <summary>Depth below which the projection magnifies errors too much; behind the camera, corners have no projection.</summary>
    private const double MinDepthMetres = 0.5;

    private UprightBox(Cuboid cuboid, CameraLabel camera)
    {
        Vector3D centre = InKitti(camera.Pose.ToLocal(cuboid.Centre));
        Vector3D forward = InKitti(camera.Pose.Axes.ToLocal(cuboid.Axes.Forward));
        Height = 2 * cuboid.HalfExtents.Z;
        Width = 2 * cuboid.HalfExtents.X;
        Length = 2 * cuboid.HalfExtents.Y;
        Location = centre with { Y = centre.Y + (Height / 2) };

        // 0 - z instead of -z: the arctangent of minus zero would give -π instead of π.
        RotationY = Math.Atan2(0 - forward.Z, forward.X);
        LeanDegrees = Angles.ToDegrees(Math.Acos(Math.Clamp(cuboid.Axes.Up.Dot(camera.Pose.Axes.Up), -1, 1)));
    }

    public double Height { get; }

    public double Width { get; }

    public double Length { get; }

    /// <summary>The centre of the bottom face, metres.</summary>
    public Vector3D Location { get; private init; }

    /// <summary>Rotation about y, radians: 0 points along x.</summary>
    public double RotationY { get; }

    /// <summary>The rotation minus the direction to the object, radians.</summary>
    public double Alpha => Angles.WrapRadians(RotationY - Math.Atan2(Location.X, Location.Z));

    /// <summary>
    /// Largest distance between the sides of the projection and those of the cuboid's, pixels; 0 if the cuboid reaches too near to the
    /// camera.
    /// </summary>
    public double MissPixels { get; private init; }

    /// <summary>Distance from the cuboid's centre, metres.</summary>
    public double MovedMetres { get; private init; }

    /// <summary>Angle between the up axes of the cuboid and of the camera, degrees.</summary>
    public double LeanDegrees { get; }

    /// <summary>The same box in the frame of a camera with the same axes.</summary>
    /// <param name="camera">This camera in the frame of the other, metres.</param>
    public UprightBox InFrameOf(Vector3D camera) => this with { Location = Location + camera };

    /// <summary>The upright box of a cuboid.</summary>
    public static UprightBox Of(Cuboid cuboid, CameraLabel camera)
    {
        var upright = new UprightBox(cuboid, camera);
        UprightBox box = upright;
        if (
            Projection([.. Enumerable.Range(0, Corners).Select(number => InKitti(camera.Pose.ToLocal(cuboid.Corner(number))))], camera)
            is not { } aim
        )
        {
            return box;
        }

        UprightProjection? seen = box.Seen(camera);
        double damping = 1;
        for (int step = 0; step < MaxSteps && seen is { } now; step++)
        {
            Vector2D miss = CentreOf(aim.Box) - CentreOf(now.Box);
            if (miss.Length < MinStepPixels)
            {
                break;
            }

            var shift = new Vector3D(miss.X / now.PixelsPerMetre.X, miss.Y / now.PixelsPerMetre.Y, 0);
            UprightBox next = box with { Location = box.Location + (shift * damping) };
            if (next.Seen(camera) is { } better && (CentreOf(aim.Box) - CentreOf(better.Box)).Length < miss.Length)
            {
                (box, seen, damping) = (next, better, 1);
            }
            else
            {
                damping /= 2;
            }
        }

        return seen is { } placed
            ? box with
            {
                MissPixels = MissOf(placed.Box, aim.Box),
                MovedMetres = (box.Location - upright.Location).Length,
            }
            : upright;
    }

    private static double MissOf(Box2D box, Box2D aim) =>
        new[]
        {
            Math.Abs(box.XMin - aim.XMin),
            Math.Abs(box.YMin - aim.YMin),
            Math.Abs(box.XMax - aim.XMax),
            Math.Abs(box.YMax - aim.YMax),
        }.Max();

    private static Vector2D CentreOf(Box2D box) => new((box.XMin + box.XMax) / 2, (box.YMin + box.YMax) / 2);

    /// <summary>From conventions.md's camera frame (x right, y forward, z up) to KITTI's.</summary>
    private static Vector3D InKitti(Vector3D local) => new(local.X, -local.Z, local.Y);

    private static UprightProjection? Projection(Vector3D[] corners, CameraLabel camera)
    {
        if (corners.Min(corner => corner.Z) < MinDepthMetres)
        {
            return null;
        }

        double U(Vector3D corner) => camera.Cx + (camera.Fx * corner.X / corner.Z);
        double V(Vector3D corner) => camera.Cy + (camera.Fy * corner.Y / corner.Z);
        (Vector3D left, Vector3D right) = (corners.MinBy(U), corners.MaxBy(U));
        (Vector3D top, Vector3D bottom) = (corners.MinBy(V), corners.MaxBy(V));
        return new UprightProjection(
            new Box2D(U(left), V(top), U(right), V(bottom)),
            new Vector2D(camera.Fx * ((1 / left.Z) + (1 / right.Z)) / 2, camera.Fy * ((1 / top.Z) + (1 / bottom.Z)) / 2)
        );
    }

    private UprightProjection? Seen(CameraLabel camera) => Projection(KittiCorners.Of(Location, Height, Width, Length, RotationY), camera);
}

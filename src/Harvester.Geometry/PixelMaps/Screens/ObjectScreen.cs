using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.PixelMaps.Screens;

/// <summary>
/// The screen behind an object: the faces of a box a little larger than the object's cuboid that are turned away from the camera, seen from
/// inside. It covers the cuboid's silhouette in the image, lies behind the object, and its floor hides the shadow under it.
/// </summary>
internal sealed class ObjectScreen
{
    /// <summary>The box is larger than the cuboid by this on each side, metres, and at least by this many pixels.</summary>
    private const double MarginMetres = 0.05;
    private const double MarginPixels = 1.5;

    /// <summary>Its floor lies so high above the lower end of the cuboid, metres, that even ground does not cover it.</summary>
    private const double LiftMetres = 0.005;

    private static readonly (int A, int B, int C, int D)[] Faces =
    [
        (0, 1, 3, 2),
        (4, 5, 7, 6),
        (0, 1, 5, 4),
        (2, 3, 7, 6),
        (0, 2, 6, 4),
        (1, 3, 7, 5),
    ];

    private ObjectScreen(Cuboid box, SilhouetteSpans spans, double distance) => (Box, Spans, DistanceMetres) = (box, spans, distance);

    /// <summary>The box whose far faces are the screen.</summary>
    public Cuboid Box { get; }

    /// <summary>The pixels that the screen covers, if nothing is in front of it.</summary>
    public SilhouetteSpans Spans { get; }

    /// <summary>Distance of the object's centre from the camera, metres.</summary>
    public double DistanceMetres { get; }

    public static ObjectScreen Of(Camera camera, MapTarget target)
    {
        Cuboid cuboid = target.Cuboid;
        double distance = SilhouettePainter.DistanceOf(camera, target);

        // A pixel at a distance d is d / fx metres wide.
        double margin = Math.Max(MarginMetres, MarginPixels * distance / camera.Intrinsics.Fx);

        // The top rises by the margin and the floor by LiftMetres, so the height grows by margin - LiftMetres, half of it on either side of
        // a centre raised by the mean of both.
        double rise = (margin - LiftMetres) / 2;
        var box = new Cuboid(
            cuboid.Centre + (cuboid.Axes.Up * (rise + LiftMetres)),
            new Vector3D(cuboid.HalfExtents.X + margin, cuboid.HalfExtents.Y + margin, Math.Max(0, cuboid.HalfExtents.Z + rise)),
            cuboid.Axes
        );
        CuboidProjection projection = CuboidProjector.Project(camera, box);
        return new ObjectScreen(
            box,
            projection.Box is { } bounds
                ? new SilhouetteSpans(projection.Silhouette, bounds, camera.Image)
                : new SilhouetteSpans([], new Box2D(0, 0, 0, 0), camera.Image),
            distance
        );
    }

    /// <summary>The sheets of the screen.</summary>
    public IEnumerable<ScreenSheet> Sheets(Vector3D eye) =>
        Faces
            .Select(face => new ScreenSheet(Box.Corner(face.A), Box.Corner(face.B), Box.Corner(face.C), Box.Corner(face.D)))
            .Where(sheet => IsFar(sheet, eye));

    /// <summary>Number of pixels that two screens share, each widened by a pixel.</summary>
    public int PixelsSharedWith(ObjectScreen other)
    {
        int shared = 0;
        int last = Math.Min(Spans.LastRow, other.Spans.LastRow);
        for (int row = Math.Max(Spans.FirstRow, other.Spans.FirstRow); row <= last; row++)
        {
            (int first, int end) = Spans.Row(row);
            (int otherFirst, int otherEnd) = other.Spans.Row(row);

            // Overlap of [first - 1, end + 1] and the other span, one of them widened by a pixel on either side.
            shared +=
                first <= end && otherFirst <= otherEnd ? Math.Max(0, Math.Min(end, otherEnd) + 1 - Math.Max(first, otherFirst) + 1) : 0;
        }

        return shared;
    }

    private bool IsFar(ScreenSheet sheet, Vector3D eye)
    {
        // A face is seen from inside if its outward normal, which points from the box's centre to the face's middle, points away from the
        // eye.
        Vector3D middle = (sheet.A + sheet.C) * 0.5;
        return (middle - Box.Centre).Dot(middle - eye) > 0;
    }
}

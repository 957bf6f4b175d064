using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// Projects lane boundaries and painted markings into an image, clips them to its border, and finds by rays which points are hidden.
/// </summary>
public static class LaneLineProjector
{
    /// <summary>Height above the paint at which a ray ends, so that it does not graze the road before it, metres.</summary>
    private const double AboveRoad = 0.005;

    /// <summary>
    /// A ray to a point of the road hits the road near that point. A hit nearer by more than this hides the point, metres.
    /// </summary>
    private const double SurfaceTolerance = 0.3;

    /// <summary>The same tolerance as a fraction of the distance, for rays at a grazing angle.</summary>
    private const double SurfaceToleranceFraction = 0.05;

    /// <summary>Bisections of a piece of 0.5 m to 2 m, to 2 m / 2^22 = 0.5 µm.</summary>
    private const int Halvings = 22;

    /// <summary>Projects a line as far as it lies in the image.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="line">The line.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, such as the car that carries the camera; <see
    /// cref="RayHit.World"/> if there is none.</param>
    /// <param name="rays">The ray caster; null to leave open which points are hidden.</param>
    /// <returns>The runs of the line within the image; empty if it is not in view.</returns>
    public static IReadOnlyList<LaneLineView> Project(Camera camera, LaneLine line, int ignoredEntity, IRayCaster? rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(line, nameof(line));
        var views = new List<LaneLineView>();
        var run = new List<LaneLinePoint>();
        for (int i = 0; i < line.Points.Count; i++)
        {
            Vector3D point = line.Points[i].World;
            bool isInside = IsInside(camera, point);
            if (i > 0 && isInside != IsInside(camera, line.Points[i - 1].World))
            {
                LinePoint inner = isInside ? line.Points[i] : line.Points[i - 1];
                LinePoint outer = isInside ? line.Points[i - 1] : line.Points[i];
                run.Add(Seen(camera, line, inner with { World = Border(camera, inner.World, outer.World) }, ignoredEntity, rays));
            }

            if (isInside)
            {
                run.Add(Seen(camera, line, line.Points[i], ignoredEntity, rays));
            }
            else
            {
                Close(views, line, ref run);
            }
        }

        Close(views, line, ref run);
        return views;
    }

    /// <summary>
    /// Maximum number of rays that a marking takes: one for each point, and one for each point where it enters or leaves the image.
    /// </summary>
    public static int MaxRays(LaneLine line) => 2 * Guard.NotNull(line, nameof(line)).Points.Count;

    private static void Close(List<LaneLineView> views, LaneLine line, ref List<LaneLinePoint> run)
    {
        if (run.Count > 1)
        {
            views.Add(new LaneLineView(line.Index, line.IsLeftOfCar, run) { Paint = line.Paint, SigmaMetres = line.SigmaMetres });
        }

        run = [];
    }

    private static bool IsInside(Camera camera, Vector3D point) => camera.Project(point).Outcome == ProjectionOutcome.InImage;

    /// <summary>The last point inside the image between a point inside and one outside.</summary>
    private static Vector3D Border(Camera camera, Vector3D inside, Vector3D outside)
    {
        for (int i = 0; i < Halvings; i++)
        {
            Vector3D middle = (inside + outside) * 0.5;
            if (IsInside(camera, middle))
            {
                inside = middle;
            }
            else
            {
                outside = middle;
            }
        }

        return inside;
    }

    private static LaneLinePoint Seen(Camera camera, LaneLine line, LinePoint place, int ignoredEntity, IRayCaster? rays)
    {
        Vector3D point = place.World;
        bool? isHidden = rays is null ? null : IsHidden(camera.Pose.Position, point, line.Paint is not null, ignoredEntity, rays);
        return new LaneLinePoint(point, camera.Pose.ToLocal(point), camera.Project(point).Pixel, isHidden) { IsPainted = place.IsPainted };
    }

    /// <summary>Whether a ray hits something in front of a point. Paint lies on the road; a boundary only approximately.</summary>
    private static bool IsHidden(Vector3D eye, Vector3D point, bool isOnRoad, int ignoredEntity, IRayCaster rays)
    {
        Vector3D toPoint = (isOnRoad ? point + new Vector3D(0, 0, AboveRoad) : point) - eye;
        double distance = toPoint.Length;

        // The ray ends short of the point, by the height above the paint or by the tolerance of a boundary: a hit before that hides the
        // point.
        double clear = distance - (isOnRoad ? AboveRoad : Math.Max(SurfaceTolerance, SurfaceToleranceFraction * distance));
        return clear > 0 && rays.Cast(new Ray(eye, toPoint), clear, ignoredEntity) is not null;
    }
}

using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Lanes;

/// <summary>Brings lane boundaries and painted markings into an image: cut at its border, with what is hidden told by rays.</summary>
public static class LaneLineProjector
{
    /// <summary>A ray to so much above the paint does not graze the road before it, metres.</summary>
    private const double AboveRoad = 0.005;

    /// <summary>A ray to a point of the road meets the road about there; what it meets this much before hides the point, metres.</summary>
    private const double SurfaceTolerance = 0.3;

    /// <summary>The same in proportion to the distance, for rays that graze the road.</summary>
    private const double SurfaceToleranceFraction = 0.05;

    /// <summary>Halvings of a piece of half a metre to two metres: to a millionth of a metre.</summary>
    private const int Halvings = 22;

    /// <summary>Projects a line.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="line">The line.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, as the car that carries the camera; <see cref="RayHit.World"/>
    /// for none.</param>
    /// <param name="rays">What rays meet; null to leave open what is hidden.</param>
    /// <returns>The runs of the line within the image; none when it is not in view.</returns>
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
    /// The greatest number of rays that a marking may take: one for each point, and one for each place where it enters or leaves the image.
    /// </summary>
    public static int MaxRays(LaneLine line) => 2 * Guard.NotNull(line, nameof(line)).Points.Count;

    private static void Close(List<LaneLineView> views, LaneLine line, ref List<LaneLinePoint> run)
    {
        if (run.Count > 1)
        {
            views.Add(new LaneLineView(line.Index, line.IsLeftOfCar, run) { Paint = line.Paint });
        }

        run = [];
    }

    private static bool IsInside(Camera camera, Vector3D point) => camera.Project(point).Outcome == ProjectionOutcome.InImage;

    /// <summary>The last point inside the image between one inside and one outside.</summary>
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

    /// <summary>Whether a ray meets something before a point: one of paint lies on the road, one of a boundary about there.</summary>
    private static bool IsHidden(Vector3D eye, Vector3D point, bool isOnRoad, int ignoredEntity, IRayCaster rays)
    {
        Vector3D toPoint = (isOnRoad ? point + new Vector3D(0, 0, AboveRoad) : point) - eye;
        double distance = toPoint.Length;
        double clear = distance - (isOnRoad ? AboveRoad : Math.Max(SurfaceTolerance, SurfaceToleranceFraction * distance));
        return clear > 0 && rays.Cast(new Ray(eye, toPoint), clear, ignoredEntity) is not null;
    }
}

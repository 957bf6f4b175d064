using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Lanes;

/// <summary>Brings markings into an image: cut at its border, with what is hidden told by rays.</summary>
public static class LaneLineProjector
{
    /// <summary>A ray to a point of the road meets the road about there; what it meets this much before hides the point, metres.</summary>
    private const double SurfaceTolerance = 0.3;

    /// <summary>The same in proportion to the distance, for rays that graze the road.</summary>
    private const double SurfaceToleranceFraction = 0.05;

    /// <summary>Halvings of a piece of half a metre to two metres: to a millionth of a metre.</summary>
    private const int Halvings = 22;

    /// <summary>Projects a marking.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="line">The marking.</param>
    /// <param name="ignoredEntity">Handle of an entity that hides nothing, as the car that carries the camera; <see cref="RayHit.World"/> for none.</param>
    /// <param name="rays">What rays meet; null to leave open what is hidden.</param>
    /// <returns>The runs of the marking within the image; none when it is not in view.</returns>
    public static IReadOnlyList<LaneLineView> Project(Camera camera, LaneLine line, int ignoredEntity, IRayCaster? rays)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(line, nameof(line));
        var views = new List<LaneLineView>();
        var run = new List<LaneLinePoint>();
        for (int i = 0; i < line.Points.Count; i++)
        {
            Vector3D point = line.Points[i];
            bool isInside = IsInside(camera, point);
            if (i > 0 && isInside != IsInside(camera, line.Points[i - 1]))
            {
                Vector3D border = isInside ? Border(camera, point, line.Points[i - 1]) : Border(camera, line.Points[i - 1], point);
                run.Add(Seen(camera, border, ignoredEntity, rays));
            }

            if (isInside)
            {
                run.Add(Seen(camera, point, ignoredEntity, rays));
            }
            else
            {
                Close(views, line, ref run);
            }
        }

        Close(views, line, ref run);
        return views;
    }

    private static void Close(List<LaneLineView> views, LaneLine line, ref List<LaneLinePoint> run)
    {
        if (run.Count > 1)
        {
            views.Add(new LaneLineView(line.Index, line.IsLeftOfCar, run));
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

    private static LaneLinePoint Seen(Camera camera, Vector3D point, int ignoredEntity, IRayCaster? rays)
    {
        Projection projection = camera.Project(point);
        Vector3D toPoint = point - camera.Pose.Position;
        double distance = toPoint.Length;
        double clear = distance - Math.Max(SurfaceTolerance, SurfaceToleranceFraction * distance);
        bool? isHidden = rays is null
            ? null
            : clear > 0 && rays.Cast(new Ray(camera.Pose.Position, toPoint), clear, ignoredEntity) is not null;
        return new LaneLinePoint(point, camera.Pose.ToLocal(point), projection.Pixel, isHidden);
    }
}

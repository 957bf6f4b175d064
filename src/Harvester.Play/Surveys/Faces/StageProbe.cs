using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Play.Surveys.Faces;

/// <summary>Casts rays at a model on the stage, along the axes of its own frame.</summary>
internal sealed class StageProbe(IRayCaster rays, StagedModel model)
{
    /// <summary>
    /// Distance outside the model's box at which rays begin and end, metres: shapes that rays hit may extend beyond it a little.
    /// </summary>
    private const double Clearance = 0.3;

    /// <summary>Where a ray that runs forward at (x, z) first hits the model: y in its frame; null if it misses.</summary>
    public double? FromBehind(double x, double z) =>
        Cast(new Vector3D(x, model.Min.Y - Clearance, z), new Vector3D(0, 1, 0), model.Max.Y - model.Min.Y) is { } distance
            ? model.Min.Y - Clearance + distance
            : null;

    /// <summary>Where a ray that runs backward at (x, z) first hits the model: y in its frame; null if it misses.</summary>
    public double? FromAhead(double x, double z) =>
        Cast(new Vector3D(x, model.Max.Y + Clearance, z), new Vector3D(0, -1, 0), model.Max.Y - model.Min.Y) is { } distance
            ? model.Max.Y + Clearance - distance
            : null;

    /// <summary>Distance from a point of the model's frame to its right at which a ray hits the model; null if it misses.</summary>
    public double? ToRight(Vector3D from) => Cast(from, new Vector3D(1, 0, 0), Clearance);

    private double? Cast(Vector3D from, Vector3D direction, double reach)
    {
        var ray = new Ray(model.Pose.ToWorld(from), model.Pose.Axes.ToWorld(direction));
        return rays.Cast(ray, Math.Max(reach, 0) + (2 * Clearance), RayHit.World) is { } hit && hit.Entity == model.Handle
            ? hit.Distance
            : null;
    }
}

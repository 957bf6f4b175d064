using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Tests.Labelling;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>
/// Holds a label against what its picture truly shows: the camera, the ego, and all that is labelled or seen. What is seen has a label.
/// Only where rays may fail to meet it, which is what the quirk says, may it have an ignore region instead, over all of its pixels.
/// </summary>
internal static class FrameJudge
{
    /// <summary>
    /// Two readings of a standing scene may each be 1 mm from the first of the run (HarvestOptions.StillToleranceMetres).
    /// </summary>
    private const double PositionTolerance = 0.002;

    /// <summary>Twice the protocol's tolerance for axes.</summary>
    private const double AxisTolerance = 2e-4;

    /// <summary>
    /// Rays hit every entity up to this distance, metres (GameQuirks.RayMissFraction), minus the camera's movement while the game is read.
    /// </summary>
    private const double MetUpTo = 29;

    /// <summary>What the label says wrongly of the picture; empty when they agree.</summary>
    public static IEnumerable<string> Disagreements(FrameLabel label, TruePicture picture, double range)
    {
        SceneSnapshot truth = picture.Scene;
        if (!AreSame(label.Camera.Pose, truth.Camera.Pose))
        {
            yield return $"camera at {label.Camera.Pose.Position}, in truth at {truth.Camera.Pose.Position}";
        }

        if ((label.Ego.Position - truth.Ego.Pose.Position).Length >= PositionTolerance)
        {
            yield return $"ego at {label.Ego.Position}, in truth at {truth.Ego.Pose.Position}";
        }

        foreach (ObjectLabel item in label.Objects.Where(item => !truth.Entities.Any(entity => IsOf(item, entity))))
        {
            yield return $"{item.Model} at {item.Box3D.Centre} is labelled but not shown there";
        }

        // An entity at the very border of the range may count as within it for one camera and not for the other.
        foreach (EntityState entity in truth.Entities.Where(entity => picture.PixelsOf(entity.Handle).Count > 0))
        {
            double distance = (entity.Pose.Position - truth.Camera.Pose.Position).Length;
            bool isMarked = distance > MetUpTo && label.IgnoreRegions.Any(region => IsOf(region, entity, picture));
            if (distance < range - 1 && !isMarked && !label.Objects.Any(item => IsOf(item, entity)))
            {
                yield return $"{entity.Model} at {entity.Pose.Position} is seen but neither labelled nor marked";
            }
        }
    }

    private static bool IsOf(IgnoreRegion region, EntityState entity, TruePicture picture) =>
        region.Reason == IgnoreReason.Undetermined
        && region.Class == entity.Class
        && picture.PixelsWithin(entity.Handle, region.Box2D) == picture.PixelsOf(entity.Handle).Count;

    private static bool IsOf(ObjectLabel item, EntityState entity)
    {
        Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
        return item.Model == entity.Model
            && (item.Box3D.Centre - cuboid.Centre).Length < PositionTolerance
            && (item.Box3D.Axes.Forward - cuboid.Axes.Forward).Length < AxisTolerance;
    }

    private static bool AreSame(Pose a, Pose b) =>
        (a.Position - b.Position).Length < PositionTolerance && (a.Axes.Forward - b.Axes.Forward).Length < AxisTolerance;
}

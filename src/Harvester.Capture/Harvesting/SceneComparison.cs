using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Decides whether two readings show the same still scene: the same time, camera, ego vehicle, entities and joints, at the same positions.
/// The time of day and the frame count continue in a frozen game and are not compared; nor are velocities, which a frozen game may report
/// as 0.
/// </summary>
/// <param name="positionTolerance">Tolerance of a position, metres.</param>
internal sealed class SceneComparison(double positionTolerance)
{
    /// <summary>Tolerance of a component of an axis: less than a tenth of a pixel at a focal length of 1,000 pixels.</summary>
    private const double AxisTolerance = 1e-4;

    /// <summary>
    /// Tolerance of the game's time in a frozen game, seconds: less than a tick at 200 ticks per second, so that waiting traffic is not
    /// mistaken for a frozen game.
    /// </summary>
    private const double TimeTolerance = 0.005;

    /// <summary>
    /// The first difference, as named in the counters: timeMoved, cameraMoved, egoMoved, objectsChanged or objectMoved; null if there is
    /// none.
    /// </summary>
    public string? FirstDifference(SceneSnapshot a, SceneSnapshot b)
    {
        if (Math.Abs(a.TimeSeconds - b.TimeSeconds) > TimeTolerance)
        {
            return "timeMoved";
        }

        if (!CameraStands(a, b))
        {
            return "cameraMoved";
        }

        if (a.Ego.Handle != b.Ego.Handle || !Same(a.Ego.Pose, b.Ego.Pose))
        {
            return "egoMoved";
        }

        return FirstDifference(a.Entities, b.Entities);
    }

    public bool CameraStands(SceneSnapshot a, SceneSnapshot b) =>
        Same(a.Camera.Pose, b.Camera.Pose) && a.Camera with { Pose = b.Camera.Pose } == b.Camera;

    public string? FirstDifference(IReadOnlyList<EntityState> a, IReadOnlyList<EntityState> b)
    {
        if (a.Count != b.Count)
        {
            return "objectsChanged";
        }

        for (int i = 0; i < a.Count; i++)
        {
            if (a[i].Handle != b[i].Handle || a[i].Model != b[i].Model)
            {
                return "objectsChanged";
            }

            if (!Same(a[i].Pose, b[i].Pose) || !Same(a[i].Skeleton, b[i].Skeleton))
            {
                return "objectMoved";
            }
        }

        return null;
    }

    /// <summary>Whether no joint has moved; joints that only one of the readings has are not compared.</summary>
    private bool Same(Skeleton? a, Skeleton? b)
    {
        for (int i = 0; a is not null && b is not null && i < Skeleton.Count; i++)
        {
            if ((a.Joints[i] - b.Joints[i]).Length > positionTolerance)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Whether two poses are the same within the tolerances.</summary>
    public bool IsSame(Pose a, Pose b) => Same(a, b);

    private bool Same(Pose a, Pose b) =>
        (a.Position - b.Position).Length <= positionTolerance
        && (a.Axes.Right - b.Axes.Right).Length <= AxisTolerance
        && (a.Axes.Forward - b.Axes.Forward).Length <= AxisTolerance;
}

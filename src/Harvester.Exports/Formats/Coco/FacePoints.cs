using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Coco;

/// <summary>
/// Nose, eyes and ears, which sessions do not have: placed on a head of mean proportions, whose size is the distance from its middle to the
/// crown and which faces where the shoulders do.
/// </summary>
internal static class FacePoints
{
    /// <summary>Nose, left eye, right eye, left ear, right ear: right, forward and up of the middle of the head, in head sizes.</summary>
    private static readonly Vector3D[] Places =
    [
        new(0, 0.95, -0.1),
        new(-0.27, 0.72, 0.2),
        new(0.27, 0.72, 0.2),
        new(-0.62, 0, 0.05),
        new(0.62, 0, 0.05),
    ];

    /// <summary>The five points with their visibility: that of the head, but hidden on the side of the head away from the camera.</summary>
    public static IEnumerable<JointLabel> Of(JointsLabel joints, Camera camera)
    {
        Vector3D head = joints[Joint.HeadCenter].Position;
        Vector3D toCrown = joints[Joint.HeadTop].Position - head;
        Vector3D toRight = joints[Joint.RightShoulder].Position - joints[Joint.LeftShoulder].Position;
        if (toCrown.Length == 0 || toCrown.Cross(toRight).Length == 0)
        {
            // A head without a size or direction, as of joints that the game put in one place, has its points in its middle.
            toCrown = new Vector3D(0, 0, 0);
        }

        foreach (Vector3D place in Places)
        {
            Vector3D point = head + Offset(place, toCrown, toRight);
            Projection projection = camera.Project(point);
            bool isOnFarSide = (point - head).Dot(camera.Pose.Position - head) < 0;
            JointVisibility visibility =
                projection.Outcome != ProjectionOutcome.InImage ? JointVisibility.Outside
                : isOnFarSide && joints[Joint.HeadCenter].Visibility == JointVisibility.Visible ? JointVisibility.SelfOccluded
                : joints[Joint.HeadCenter].Visibility;
            yield return new JointLabel(
                point,
                projection.Outcome == ProjectionOutcome.BehindNearPlane ? null : projection.Pixel,
                visibility
            );
        }
    }

    private static Vector3D Offset(Vector3D place, Vector3D toCrown, Vector3D toRight)
    {
        double size = toCrown.Length;
        if (size == 0)
        {
            return Vector3D.Zero;
        }

        Vector3D up = toCrown.Normalized();
        Vector3D forward = up.Cross(toRight).Normalized();
        return ((forward.Cross(up) * place.X) + (forward * place.Y) + (up * place.Z)) * size;
    }
}

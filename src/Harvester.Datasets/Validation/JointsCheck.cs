using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the joints of a person against the camera of the frame.</summary>
internal static class JointsCheck
{
    /// <summary>Half the distance between two positions with four decimals, along a diagonal, metres.</summary>
    private const double RoundingMetres = 1e-4;

    public static IEnumerable<string> Problems(ObjectLabel item, CameraLabel label)
    {
        if (item.Joints is not { } joints || CameraOf(label) is not { } camera)
        {
            yield break;
        }

        if (!VehicleClasses.ArePeople(item.Class))
        {
            yield return "joints are given, but it is no person.";
        }

        for (int i = 0; i < joints.Joints.Count; i++)
        {
            JointLabel joint = joints.Joints[i];
            string name = JointNames.All[i];
            if (Problem(joint, camera) is { } problem)
            {
                yield return $"joint {name}: {problem}";
            }

            if (
                joints.Box is { } box
                && joint.Pixel is { } pixel
                && !box.Contains(new Box2D(pixel.X, pixel.Y, pixel.X, pixel.Y), ObjectCheck.RoundingPixels)
            )
            {
                yield return $"joint {name}: its pixel does not lie in box2dJoints {ObjectCheck.Text(box)}.";
            }
        }
    }

    /// <summary>The camera; null if it is impossible, which is reported as a problem of the camera.</summary>
    private static Camera? CameraOf(CameraLabel label)
    {
        try
        {
            return label.ToCamera();
        }
        catch (ArgumentException)
        {
            return null;
        }
    }

    private static string? Problem(JointLabel joint, Camera camera)
    {
        double depth = camera.Pose.ToLocal(joint.Position).Y;
        double near = camera.Intrinsics.NearClip;
        if (joint.Pixel is not { } pixel)
        {
            return depth > near + RoundingMetres ? "it has no pixel, but is in front of the camera."
                : joint.Visibility != JointVisibility.Outside ? "it has no pixel, but is not outside."
                : null;
        }

        Projection projection = camera.Project(joint.Position);
        double tolerance = ObjectCheck.RoundingPixels + (RoundingMetres * camera.Intrinsics.Fy / Math.Max(depth, near));
        bool isClearlyIn = Contains(camera.Image, pixel, -tolerance);
        return isClearlyIn && (projection.Pixel - pixel).Length > tolerance
                ? $"its pixel is {Text(pixel)}, but its position projects to {Text(projection.Pixel)}."
            : isClearlyIn && joint.Visibility == JointVisibility.Outside ? "it is outside, but its pixel is in the image."
            : !Contains(camera.Image, pixel, tolerance) && joint.Visibility != JointVisibility.Outside
                ? "its pixel is not in the image, but it is not outside."
            : null;
    }

    private static string Text(Vector2D pixel) => FormattableString.Invariant($"[{pixel.X:0.##}, {pixel.Y:0.##}]");

    private static bool Contains(ImageSize image, Vector2D pixel, double margin) =>
        new Box2D(0, 0, image.Width, image.Height).Contains(new Box2D(pixel.X, pixel.Y, pixel.X, pixel.Y), margin);
}

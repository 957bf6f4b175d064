using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.Coco;

/// <summary>COCO's 17 keypoints of a person.</summary>
internal static class CocoKeypoints
{
    /// <summary>The number of keypoints.</summary>
    public const int Count = 17;

    /// <summary>Not labelled: the keypoint is outside the image.</summary>
    public const int Absent = 0;

    /// <summary>Labelled but hidden.</summary>
    public const int Hidden = 1;

    /// <summary>Labelled and visible.</summary>
    public const int Visible = 2;

    /// <summary>The keypoints after the face, from shoulders to ankles, left before right.</summary>
    private static readonly Joint[] Body =
    [
        Joint.LeftShoulder,
        Joint.RightShoulder,
        Joint.LeftElbow,
        Joint.RightElbow,
        Joint.LeftWrist,
        Joint.RightWrist,
        Joint.LeftHip,
        Joint.RightHip,
        Joint.LeftKnee,
        Joint.RightKnee,
        Joint.LeftAnkle,
        Joint.RightAnkle,
    ];

    /// <summary>The category's lists of names and of lines between keypoints, counted from 1, as in COCO.</summary>
    public static string Category { get; } =
        """{"id":1,"name":"person","supercategory":"person","keypoints":["nose","left_eye","right_eye","left_ear","right_ear","""
        + "\"left_shoulder\",\"right_shoulder\",\"left_elbow\",\"right_elbow\",\"left_wrist\",\"right_wrist\",\"left_hip\",\"right_hip\","
        + "\"left_knee\",\"right_knee\",\"left_ankle\",\"right_ankle\"],"
        + "\"skeleton\":[[16,14],[14,12],[17,15],[15,13],[12,13],[6,12],[7,13],[6,7],"
        + "[6,8],[7,9],[8,10],[9,11],[2,3],[1,2],[1,3],[2,4],[3,5],[4,6],[5,7]]}";

    /// <summary>The keypoints of a person with their flags; x and y of an absent one are 0.</summary>
    public static IReadOnlyList<(double X, double Y, int Flag)> Of(JointsLabel joints, Camera camera) =>
        [.. FacePoints.Of(joints, camera).Concat(Body.Select(joint => joints[joint])).Select(Of)];

    private static (double X, double Y, int Flag) Of(JointLabel joint) =>
        joint.Visibility == JointVisibility.Outside || joint.Pixel is not { } pixel
            ? (0, 0, Absent)
            : (pixel.X, pixel.Y, joint.Visibility == JointVisibility.Visible ? Visible : Hidden);
}

namespace Harvester.Sessions.Scenes;

/// <summary>The names of joints in files, which are those of JTA.</summary>
public static class JointNames
{
    /// <summary>All names, in the order of <see cref="Joint"/>.</summary>
    public static IReadOnlyList<string> All { get; } =
    [
        "head_top",
        "head_center",
        "neck",
        "right_clavicle",
        "right_shoulder",
        "right_elbow",
        "right_wrist",
        "left_clavicle",
        "left_shoulder",
        "left_elbow",
        "left_wrist",
        "spine0",
        "spine1",
        "spine2",
        "spine3",
        "spine4",
        "right_hip",
        "right_knee",
        "right_ankle",
        "left_hip",
        "left_knee",
        "left_ankle",
    ];

    /// <summary>The name of a joint.</summary>
    public static string Of(Joint joint) => All[(int)joint];
}

namespace Harvester.Sessions.Scenes;

/// <summary>The joints of a person, in the order of the dataset JTA. Right and left are the person's own.</summary>
public enum Joint
{
    /// <summary>The crown.</summary>
    HeadTop,

    /// <summary>The middle of the head; in the game, the head's bone.</summary>
    HeadCenter,

    /// <summary>The lower end of the neck.</summary>
    Neck,

    /// <summary>The inner end of the right collarbone.</summary>
    RightClavicle,

    /// <summary>The right shoulder.</summary>
    RightShoulder,

    /// <summary>The right elbow.</summary>
    RightElbow,

    /// <summary>The right wrist.</summary>
    RightWrist,

    /// <summary>The inner end of the left collarbone.</summary>
    LeftClavicle,

    /// <summary>The left shoulder.</summary>
    LeftShoulder,

    /// <summary>The left elbow.</summary>
    LeftElbow,

    /// <summary>The left wrist.</summary>
    LeftWrist,

    /// <summary>The uppermost joint of the spine, in the chest.</summary>
    Spine0,

    /// <summary>The second joint of the spine.</summary>
    Spine1,

    /// <summary>The third joint of the spine.</summary>
    Spine2,

    /// <summary>The fourth joint of the spine.</summary>
    Spine3,

    /// <summary>The lowest joint of the spine, in the pelvis.</summary>
    Spine4,

    /// <summary>The right hip.</summary>
    RightHip,

    /// <summary>The right knee.</summary>
    RightKnee,

    /// <summary>The right ankle.</summary>
    RightAnkle,

    /// <summary>The left hip.</summary>
    LeftHip,

    /// <summary>The left knee.</summary>
    LeftKnee,

    /// <summary>The left ankle.</summary>
    LeftAnkle,
}

namespace Harvester.Simulation.People;

/// <summary>The parts of a body, between which joints lie.</summary>
internal enum BodyPart
{
    /// <summary>Head with hair, and the neck.</summary>
    Head,

    /// <summary>Chest, belly and pelvis, with a skirt or coat.</summary>
    Torso,

    /// <summary>From the right shoulder to the elbow.</summary>
    RightUpperArm,

    /// <summary>From the right elbow to the finger tips.</summary>
    RightForearm,

    /// <summary>From the left shoulder to the elbow.</summary>
    LeftUpperArm,

    /// <summary>From the left elbow to the finger tips.</summary>
    LeftForearm,

    /// <summary>From the right hip to the knee.</summary>
    RightThigh,

    /// <summary>From the right knee to the toes.</summary>
    RightShank,

    /// <summary>From the left hip to the knee.</summary>
    LeftThigh,

    /// <summary>From the left knee to the toes.</summary>
    LeftShank,
}

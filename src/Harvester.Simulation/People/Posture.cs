namespace Harvester.Simulation.People;

/// <summary>What a body does at one moment.</summary>
internal sealed record Posture
{
    /// <summary>Height of the hips above the ground, metres.</summary>
    public required double HipHeight { get; init; }

    /// <summary>The hips forward of the model's origin, metres.</summary>
    public double HipForward { get; init; }

    /// <summary>Lean of the trunk, forward positive, radians.</summary>
    public double Lean { get; init; }

    /// <summary>Turn of the shoulders against the hips, to the left positive, radians.</summary>
    public double Turn { get; init; }

    /// <summary>Nod of the head against the trunk, downward positive, radians.</summary>
    public double Nod { get; init; }

    /// <summary>The right foot.</summary>
    public required FootPosture RightFoot { get; init; }

    /// <summary>The left foot.</summary>
    public required FootPosture LeftFoot { get; init; }

    /// <summary>The right arm.</summary>
    public required ArmPosture RightArm { get; init; }

    /// <summary>The left arm.</summary>
    public required ArmPosture LeftArm { get; init; }
}

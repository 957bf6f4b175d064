namespace Harvester.Simulation.People;

/// <summary>The postures of people who stand or sit.</summary>
internal static class Rest
{
    /// <summary>Height of the seat of a bench, metres.</summary>
    public const double SeatHeight = 0.45;

    /// <summary>The hips of someone who sits are so far behind the model's origin, metres.</summary>
    public const double SeatBehind = 0.25;

    /// <summary>Waiting, on the phone, with folded arms, with the hands on the hips.</summary>
    public static IReadOnlyList<Posture> Standing(Proportions sizes)
    {
        FootPosture foot = new(0, sizes.Ankle, 0, 0.02);
        FootPosture apart = foot with { Forward = 0.08, Spread = 0.05 };
        ArmPosture hanging = new(0.03, 0.13, 0.22);
        ArmPosture onHip = new(-0.35, 0.75, 1.15, 1.5);
        Posture upright = new()
        {
            HipHeight = sizes.HipHeight - 0.012,
            Lean = 0.01,
            RightFoot = foot,
            LeftFoot = foot,
            RightArm = hanging,
            LeftArm = hanging,
        };
        return
        [
            upright with
            {
                RightFoot = apart,
            },
            upright with
            {
                RightArm = new ArmPosture(0.45, 0.12, 1.55, 0.45),
                Nod = 0.45,
                LeftFoot = apart,
            },
            upright with
            {
                RightArm = new ArmPosture(0.3, 0.12, 1.35, 1.15),
                LeftArm = new ArmPosture(0.36, 0.12, 1.2, 1.15),
            },
            upright with
            {
                RightArm = onHip,
                LeftArm = onHip,
                LeftFoot = apart,
            },
        ];
    }

    /// <summary>On a bench: with the hands on the thighs, and leaning forward over a phone.</summary>
    public static IReadOnlyList<Posture> Sitting(Proportions sizes)
    {
        double thighRadius = 0.045 * sizes.Height;
        FootPosture foot = new(sizes.Thigh - SeatBehind, sizes.Ankle, 0, 0.05);
        Posture upright = new()
        {
            HipHeight = SeatHeight + thighRadius,
            HipForward = -SeatBehind,
            Lean = -0.08,
            RightFoot = foot,
            LeftFoot = foot with { Forward = foot.Forward + 0.08 },
            RightArm = new ArmPosture(0.35, 0.15, 0.95, 0.2),
            LeftArm = new ArmPosture(0.35, 0.15, 0.95, 0.2),
        };
        return
        [
            upright,
            upright with
            {
                Lean = 0.35,
                Nod = 0.4,
                RightArm = new ArmPosture(0.45, 0.15, 1.25, 0.45),
                LeftArm = new ArmPosture(0.45, 0.15, 1.25, 0.45),
            },
        ];
    }
}

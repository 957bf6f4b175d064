namespace Harvester.Simulation.People;

/// <summary>
/// The walk of a person at the usual pace: feet that stand do not slide, knees bend where the leg is too long for the way to the hip, and
/// each arm swings with the leg of the other side. Phases and angles as in Perry, Gait Analysis: a foot stands for 60 % of a stride.
/// </summary>
/// <param name="sizes">The lengths of the limbs.</param>
/// <param name="pace">Walking speed, metres per second.</param>
internal sealed class Gait(Proportions sizes, double pace)
{
    private const double Stance = 0.6;
    private const double MeanPace = 1.35;
    private const double HeelRises = 0.38;
    private const double MaxHeelPitch = -0.95;
    private const double StrikePitch = 0.3;
    private const double FootFlat = 0.09;

    /// <summary>
    /// Distance walked in a stride, two steps, metres: 0.83 of the height at the mean pace, and in proportion to the root of the pace.
    /// </summary>
    public double StrideLength => 0.83 * sizes.Height * Math.Sqrt(pace / MeanPace);

    /// <summary>The posture at a phase of the stride, 0 to 1; at 0 the right heel strikes the ground.</summary>
    public Posture At(double phase)
    {
        FootPosture right = Foot(phase);
        FootPosture left = Foot(Wrapped(phase + 0.5));
        double vigour = Math.Clamp(pace / MeanPace, 0.6, 1.4);
        double swing = 0.36 * vigour * Math.Cos(2 * Math.PI * phase);
        return new Posture
        {
            HipHeight = Math.Min(Reach(right), Reach(left)),
            Lean = 0.03 + (0.03 * vigour),
            Turn = 0.07 * vigour * Math.Cos(2 * Math.PI * phase),
            RightFoot = right,
            LeftFoot = left,
            RightArm = Arm(-swing, vigour),
            LeftArm = Arm(swing, vigour),
        };
    }

    private static ArmPosture Arm(double swing, double vigour) => new(0.04 + swing, 0.13, (0.3 * vigour) + Math.Max(0, 0.6 * swing));

    private static double Wrapped(double phase) => phase - Math.Floor(phase);

    /// <summary>A slow start and end between 0 and 1.</summary>
    private static double Eased(double part) => part * part * (3 - (2 * part));

    private FootPosture Foot(double phase)
    {
        if (phase < Stance)
        {
            return Standing(phase);
        }

        FootPosture off = Standing(Stance);
        FootPosture strike = Standing(0);
        double part = (phase - Stance) / (1 - Stance);
        double lift = 0.04 * sizes.Height * Math.Sin(Math.PI * part);
        return new FootPosture(
            Between(off.Forward, strike.Forward, Eased(part)),
            Between(off.Height, strike.Height, Eased(part)) + lift,
            Between(off.Pitch, strike.Pitch, Eased(Math.Min(1, part * 1.25))),
            Narrow
        );
    }

    private FootPosture Standing(double phase)
    {
        double pitch =
            phase < FootFlat ? StrikePitch * (1 - Eased(phase / FootFlat))
            : phase > HeelRises ? MaxHeelPitch * Math.Pow((phase - HeelRises) / (Stance - HeelRises), 1.6)
            : 0;
        double ball = (0.55 * sizes.AnkleToBall) + (StrideLength * ((Stance / 2) - phase));
        double length = sizes.AnkleToBall;
        double height = sizes.Ankle;

        // The foot turns about its ball when the heel rises, and about the heel when the toes come down.
        return pitch < 0
            ? new FootPosture(
                ball - (length * Math.Cos(pitch)) - (height * Math.Sin(pitch)),
                (height * Math.Cos(pitch)) - (length * Math.Sin(pitch)),
                pitch,
                Narrow
            )
            : new FootPosture(ball - length, height + (sizes.AnkleToHeel * Math.Sin(pitch)), pitch, Narrow);
    }

    /// <summary>Feet are set nearer to the middle than the hips.</summary>
    private double Narrow => -0.02 * sizes.Height;

    /// <summary>The height at which the hips are when a leg is almost straight.</summary>
    private double Reach(FootPosture foot)
    {
        const double straightness = 0.992;
        double leg = straightness * (sizes.Thigh + sizes.Shank);
        double level = (foot.Forward * foot.Forward) + (foot.Spread * foot.Spread);
        return foot.Height + Math.Sqrt((leg * leg) - level);
    }

    private static double Between(double from, double to, double part) => from + ((to - from) * part);
}

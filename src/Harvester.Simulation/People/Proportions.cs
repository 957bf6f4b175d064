namespace Harvester.Simulation.People;

/// <summary>
/// Lengths of a person's limbs, metres. Fractions of the height after Drillis and Contini (1966), as in Winter, Biomechanics and Motor
/// Control of Human Movement; joints of the spine are spread evenly as the game's bones are.
/// </summary>
/// <param name="Height">Height of the person.</param>
/// <param name="Shoulders">Width of the shoulders, relative to the mean.</param>
internal readonly record struct Proportions(double Height, double Shoulders)
{
    public double Thigh => 0.245 * Height;

    public double Shank => 0.236 * Height;

    /// <summary>Height of the ankle above the sole.</summary>
    public double Ankle => 0.039 * Height;

    /// <summary>From the ankle forward to the ball of the foot.</summary>
    public double AnkleToBall => 0.075 * Height;

    /// <summary>From the ankle forward to the toes.</summary>
    public double AnkleToToe => 0.113 * Height;

    /// <summary>From the ankle back to the heel.</summary>
    public double AnkleToHeel => 0.035 * Height;

    public double UpperArm => 0.175 * Height;

    public double Forearm => 0.146 * Height;

    public double Hand => 0.1 * Height;

    /// <summary>From the middle to a hip.</summary>
    public double HipAside => 0.054 * Height;

    /// <summary>From the middle to a shoulder.</summary>
    public double ShoulderAside => 0.112 * Height * Shoulders;

    /// <summary>Height of the hips of a person standing upright.</summary>
    public double HipHeight => Thigh + Shank + Ankle;
}

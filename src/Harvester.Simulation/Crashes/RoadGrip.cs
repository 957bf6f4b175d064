namespace Harvester.Simulation.Crashes;

/// <summary>What tyres can do on a road.</summary>
/// <param name="Braking">Deceleration of a vehicle that brakes hard, m/s².</param>
/// <param name="Sliding">Deceleration of a vehicle that slides on locked wheels, m/s².</param>
/// <param name="LyingSlide">Deceleration of a two-wheeler that slides on its side, m/s².</param>
internal sealed record RoadGrip(double Braking, double Sliding, double LyingSlide)
{
    private const double Gravity = 9.81;

    /// <summary>
    /// Hard braking at 8 m/s², as all traffic here; locked wheels slide with 0.7 and motorcycles on their side with 0.5 (mean values of
    /// reconstruction handbooks).
    /// </summary>
    public static RoadGrip Dry { get; } = new(8, 0.7 * Gravity, 0.5 * Gravity);

    /// <summary>The grip when it rains.</summary>
    /// <param name="rainFraction">From 0, dry, to 1, heavy rain, in which about a third of the grip is gone.</param>
    public static RoadGrip In(double rainFraction)
    {
        const double lost = 0.35;
        double left = 1 - (lost * rainFraction);
        return new RoadGrip(Dry.Braking * left, Dry.Sliding * left, Dry.LyingSlide * left);
    }
}

namespace Harvester.Simulation.Traffic;

/// <summary>A driver's order to brake and stand.</summary>
/// <param name="Deceleration">m/s².</param>
/// <param name="UntilSeconds">The world's time until which it holds; infinite for ever.</param>
internal sealed record OrderedBraking(double Deceleration, double UntilSeconds)
{
    /// <summary>The acceleration of a driver who wants another one, m/s².</summary>
    public double Limit(double wanted, double timeSeconds) => timeSeconds < UntilSeconds ? Math.Min(wanted, -Deceleration) : wanted;
}

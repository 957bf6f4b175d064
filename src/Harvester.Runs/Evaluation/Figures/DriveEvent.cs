using Harvester.Geometry;

namespace Harvester.Runs.Evaluation.Figures;

/// <summary>An event of a drive.</summary>
/// <param name="TimeSeconds">Game time, seconds.</param>
/// <param name="X">East, world, metres.</param>
/// <param name="Y">North, world, metres.</param>
/// <param name="IsByController">Whether the controller drove, not the built-in driver.</param>
/// <param name="IsInJunction">Whether the car was in a junction.</param>
public sealed record DriveEvent(double TimeSeconds, double X, double Y, bool IsByController, bool IsInJunction)
{
    private const int Decimals = 3;

    /// <summary>Index of the episode in which it happened.</summary>
    public int Episode { get; init; }

    internal Vector2D Place => new(X, Y);

    internal string Description =>
        FormattableString.Invariant($"{TimeSeconds:0.0} s at {X:0.0}, {Y:0.0} m, ")
        + (IsByController ? "controller" : "built-in driver")
        + (IsInJunction ? ", in a junction" : "");

    /// <summary>The event at a sample.</summary>
    /// <param name="sample">The sample.</param>
    /// <param name="episode">Index of the episode.</param>
    public static DriveEvent At(DriveSample sample, int episode = 0)
    {
        ArgumentNullException.ThrowIfNull(sample);
        return new DriveEvent(
            Math.Round(sample.TimeSeconds, Decimals),
            Math.Round(sample.Position.X, Decimals) + 0.0,
            Math.Round(sample.Position.Y, Decimals) + 0.0,
            sample.IsByController,
            sample.Lane is null
        )
        {
            Episode = episode,
        };
    }
}

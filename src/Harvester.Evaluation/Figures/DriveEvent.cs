using System;
using Harvester.Geometry;

namespace Harvester.Evaluation.Figures;

/// <summary>Something that happened in a drive.</summary>
/// <param name="TimeSeconds">When, seconds of the game's time.</param>
/// <param name="X">Where, metres, world.</param>
/// <param name="Y">Where, metres, world.</param>
/// <param name="IsByController">Whether the controller drove then, or the car's own driver.</param>
/// <param name="IsInJunction">Whether it was in a junction.</param>
public sealed record DriveEvent(double TimeSeconds, double X, double Y, bool IsByController, bool IsInJunction)
{
    private const int Decimals = 3;

    internal Vector2D Place => new(X, Y);

    internal string Description =>
        FormattableString.Invariant($"{TimeSeconds:0.0} s at {X:0.0}, {Y:0.0} m, {(IsByController ? "controller" : "built-in driver")}{(IsInJunction ? ", in a junction" : "")}");

    /// <summary>What happened at a sample.</summary>
    public static DriveEvent At(DriveSample sample)
    {
        ArgumentNullException.ThrowIfNull(sample);
        return new DriveEvent(
            Math.Round(sample.TimeSeconds, Decimals),
            Math.Round(sample.Position.X, Decimals) + 0.0,
            Math.Round(sample.Position.Y, Decimals) + 0.0,
            sample.IsByController,
            sample.Lane is null);
    }
}

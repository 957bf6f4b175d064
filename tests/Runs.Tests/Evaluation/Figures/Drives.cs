using Harvester.Geometry;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Figures;

/// <summary>Drives northwards at 10 m/s, sampled ten times a second, in a lane 5.4 m wide with a car 2 m wide.</summary>
internal static class Drives
{
    public static DriveSample At(int index, double right = 0, int? lane = 0, int lanes = 1) =>
        new()
        {
            TimeSeconds = index / 10.0,
            Position = new Vector2D(right, index),
            Speed = 10,
            IsByController = true,
            Lane = new LanePlacement(7, lane, lanes, 5.4, right, 1),
        };

    public static DriveSample[] Of(params double[] rightOfMiddle) => [.. rightOfMiddle.Select((right, i) => At(i, right))];
}

namespace Harvester.Runs.Evaluation.Noise;

/// <summary>Mean absolute errors of a network that estimates the indicators from images.</summary>
/// <param name="AngleRadians">Error of the angle, radians.</param>
/// <param name="MarkingMetres">Error of distances to markings, metres.</param>
/// <param name="VehicleMetres">Error of distances to vehicles, metres.</param>
public sealed record NoiseLevels(double AngleRadians, double MarkingMetres, double VehicleMetres)
{
    /// <summary>Approximately the published errors of DeepDriving's network.</summary>
    public static NoiseLevels Published { get; } = new(0.03, 0.2, 3);
}

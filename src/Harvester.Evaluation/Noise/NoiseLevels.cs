namespace Harvester.Evaluation.Noise;

/// <summary>Mean absolute errors of a network that reads the indicators off pictures.</summary>
/// <param name="AngleRadians">Of the angle, radians.</param>
/// <param name="MarkingMetres">Of distances to markings, metres.</param>
/// <param name="VehicleMetres">Of distances to vehicles, metres.</param>
public sealed record NoiseLevels(double AngleRadians, double MarkingMetres, double VehicleMetres)
{
    /// <summary>About what is published for DeepDriving's network.</summary>
    public static NoiseLevels Published { get; } = new(0.03, 0.2, 3);
}

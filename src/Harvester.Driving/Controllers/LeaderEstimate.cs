using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Estimates distance and speed of the vehicle ahead from noisy distances: an alpha-beta filter that knows the car's own speed.
/// </summary>
/// <param name="speedOfNewcomers">Assumed speed of a vehicle that has just come into sight, m/s; null for the car's own speed.</param>
internal sealed class LeaderEstimate(double? speedOfNewcomers = null)
{
    /// <summary>Weight of a measured distance against the predicted one (the alpha of an alpha-beta filter).</summary>
    private const double GapWeight = 0.35;

    /// <summary>
    /// Weight at a standstill. A car cannot reverse: if the noise of each frame moved the estimate, a car that waits would creep up to the
    /// vehicle whenever the vehicle seems to be farther away.
    /// </summary>
    private const double GapWeightAtRest = 0.08;

    /// <summary>Own speed from which the full weight applies, m/s.</summary>
    private const double FullWeightSpeed = 1.5;

    /// <summary>A distance that differs by more belongs to another vehicle, metres.</summary>
    private const double OtherVehicle = 14;

    /// <summary>Number of frames without the vehicle after which it is gone.</summary>
    private const int FramesUntilGone = 3;

    private int _framesWithout;

    /// <summary>Distance to it, centre to centre, metres; null if there is none.</summary>
    public double? Gap { get; private set; }

    /// <summary>Its speed along the road, m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>Adds a frame: the nearest of the vehicles ahead in the lane, or in the two lanes that the car is between.</summary>
    /// <param name="at">The indicators of the frame, metres.</param>
    /// <param name="ownSpeed">The car's own speed, m/s.</param>
    /// <param name="seconds">Time since the previous frame, seconds.</param>
    public void Observe(LaneIndicators at, double ownSpeed, double seconds)
    {
        double nearest = Math.Min(DistanceOf(at.DistMM), Math.Min(DistanceOf(at.DistL), DistanceOf(at.DistR)));
        Observe(nearest < TorcsEquivalent.VehicleRange ? nearest : null, ownSpeed, seconds);
    }

    private static double DistanceOf(Indicator distance) => distance.IsValid ? distance.Value : double.PositiveInfinity;

    private void Observe(double? measured, double ownSpeed, double seconds)
    {
        if (measured is not { } distance)
        {
            _framesWithout++;
            Gap = _framesWithout >= FramesUntilGone ? null : Gap + ((Speed - ownSpeed) * seconds);
            return;
        }

        _framesWithout = 0;
        if (Gap is { } gap && Math.Abs(distance - gap) < OtherVehicle)
        {
            // An alpha-beta filter: predict by the relative speed, then correct gap and speed by parts of the residual.
            double predicted = gap + ((Speed - ownSpeed) * seconds);
            double residual = distance - predicted;
            double weight = GapWeightAtRest + ((GapWeight - GapWeightAtRest) * Math.Min(1, ownSpeed / FullWeightSpeed));
            Gap = predicted + (weight * residual);

            // The weight of the speed that fits that of the gap, without overshoot: β = α² / (2 - α) (Benedict and Bordner 1962).
            Speed = Math.Max(0, Speed + (weight * weight / (2 - weight) * residual / seconds));
        }
        else
        {
            Gap = distance;
            Speed = speedOfNewcomers ?? ownSpeed;
        }
    }
}

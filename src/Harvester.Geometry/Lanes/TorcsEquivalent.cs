using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// The indicators as a road of TORCS would give them, for controllers and networks made for it: distances to markings scaled by 4.0 / lane
/// width, distances to vehicles limited to 60 m, and the angle at the car. Inactive values are unchanged.
/// </summary>
public static class TorcsEquivalent
{
    /// <summary>DeepDriving's value for a lane without a vehicle in range, metres.</summary>
    public const double VehicleRange = 60;

    /// <summary>
    /// Scales indicators measured at a look-ahead point, and replaces their angle by that at the car, as TORCS measures it.
    /// </summary>
    /// <param name="indicators">Metres and radians, at the look-ahead point.</param>
    /// <param name="section">The lanes at the look-ahead point.</param>
    /// <param name="offset">The car's position, metres to the right of the left edge of these lanes.</param>
    /// <param name="angleAtCar">The angle between road and car at the car, radians.</param>
    /// <exception cref="ArgumentNullException"><paramref name="indicators"/> is null.</exception>
    public static LaneIndicators Of(LaneIndicators indicators, LaneSection section, double offset, Indicator angleAtCar) =>
        Guard
            .NotNull(indicators, nameof(indicators))
            .Select(toMarking => toMarking.IsValid ? Indicator.Of(section.TorcsDistance(offset, toMarking.Value)) : toMarking, Cut) with
        {
            Angle = angleAtCar,
        };

    /// <summary>Scales indicators measured at the car on lanes of a given mean width.</summary>
    public static LaneIndicators Of(LaneIndicators indicators, LaneSection section) =>
        Guard.NotNull(indicators, nameof(indicators)).Select(toMarking => Scaled(toMarking, section.TorcsScale), Cut);

    /// <summary>
    /// The inverse: indicators of a TORCS road in metres on lanes of a given mean width. Distances to vehicles stay limited.
    /// </summary>
    public static LaneIndicators InMetres(LaneIndicators torcsEquivalent, LaneSection section) =>
        Guard
            .NotNull(torcsEquivalent, nameof(torcsEquivalent))
            .Select(toMarking => Scaled(toMarking, 1 / section.TorcsScale), dist => dist);

    private static Indicator Scaled(Indicator indicator, double scale) =>
        indicator.IsValid ? Indicator.Of(indicator.Value * scale) : indicator;

    private static Indicator Cut(Indicator indicator) =>
        indicator.IsValid ? Indicator.Of(Math.Min(indicator.Value, VehicleRange)) : indicator;
}

using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Runs.Evaluation.Noise;

/// <summary>
/// Adds the errors of a network to a controller's indicators: normally distributed, independent between indicators and frames. The levels
/// are those on a road of TORCS; in metres on a wider lane they are proportionally larger. Everything but the thirteen numbers stays exact:
/// which of them are valid, the lane width, whether the road is straight for long, and the car's speed and heading.
/// </summary>
public sealed class NoisyIndicators : IController
{
    /// <summary>Ratio of the standard deviation to the mean absolute value of a normal distribution: √(π/2).</summary>
    private static readonly double DeviationByMeanError = Math.Sqrt(Math.PI / 2);

    private readonly IController _controller;
    private readonly NoiseLevels _levels;
    private readonly Random _random;

    /// <summary>Wraps a controller.</summary>
    public NoisyIndicators(IController controller, NoiseLevels levels, int seed)
    {
        ArgumentNullException.ThrowIfNull(controller);
        ArgumentNullException.ThrowIfNull(levels);
        _controller = controller;
        _levels = levels;
        _random = new Random(seed);
    }

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        ArgumentNullException.ThrowIfNull(state);
        LaneIndicators truth = state.Indicators;
        double scale = LaneScale(state);
        LaneIndicators metres = (truth with { Angle = Noisy(truth.Angle, _levels.AngleRadians) }).Select(
            toMarking => Noisy(toMarking, _levels.MarkingMetres * scale),
            NoisyDistance
        );
        return _controller.Drive(
            state with
            {
                Indicators = metres,
                TorcsEquivalent = TorcsEquivalent.Of(
                    metres,
                    new LaneSection(1, LaneSection.TorcsLaneWidth * scale),
                    offset: 0,
                    WithErrorOf(state.TorcsEquivalent.Angle, truth.Angle, metres.Angle)
                ),
            }
        );
    }

    /// <summary>An angle with the error of another one: a network has the same error in both.</summary>
    private static Indicator WithErrorOf(Indicator angle, Indicator truth, Indicator noisy) =>
        angle.IsValid && truth.IsValid ? Indicator.Of(angle.Value + (noisy.Value - truth.Value)) : angle;

    /// <summary>Metres on the road per metre on a road of TORCS.</summary>
    private static double LaneScale(DrivingState state)
    {
        LaneIndicators metres = state.Indicators;
        LaneIndicators torcs = state.TorcsEquivalent;
        return metres.ToMarkingML.IsValid && metres.ToMarkingMR.IsValid
                ? (metres.ToMarkingMR.Value - metres.ToMarkingML.Value) / (torcs.ToMarkingMR.Value - torcs.ToMarkingML.Value)
            : metres.ToMarkingM.IsValid && metres.ToMarkingR.IsValid
                ? (metres.ToMarkingR.Value - metres.ToMarkingM.Value) / (torcs.ToMarkingR.Value - torcs.ToMarkingM.Value)
            : metres.ToMarkingM.IsValid && metres.ToMarkingL.IsValid
                ? (metres.ToMarkingM.Value - metres.ToMarkingL.Value) / (torcs.ToMarkingM.Value - torcs.ToMarkingL.Value)
            : 1;
    }

    private Indicator Noisy(Indicator indicator, double meanError) =>
        indicator.IsValid ? Indicator.Of(indicator.Value + (Normal() * meanError * DeviationByMeanError)) : indicator;

    private Indicator NoisyDistance(Indicator indicator) =>
        indicator.IsValid
            ? Indicator.Of(Math.Clamp(Noisy(indicator, _levels.VehicleMetres).Value, 0, IndicatorCalculator.VehicleRange))
            : indicator;

    /// <summary>A standard normal number (Box and Muller).</summary>
    private double Normal() => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}

using System;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Noise;

/// <summary>
/// Lets a controller see the indicators as a network would that errs: normal errors, independent from indicator to indicator and from
/// frame to frame. Which indicators are active it knows as they are. The errors are those on a road of TORCS; in metres of a wider lane
/// they are as much larger.
/// </summary>
public sealed class NoisyIndicators : IController
{
    /// <summary>Standard deviation of a normal error by its mean absolute value: √(π/2).</summary>
    private static readonly double DeviationByMeanError = Math.Sqrt(Math.PI / 2);

    private readonly IController _controller;
    private readonly NoiseLevels _levels;
    private readonly Random _random;

    /// <summary>Puts noise before a controller.</summary>
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
        double scale = LaneScale(state);
        LaneIndicators torcs = WithNoise(state.TorcsEquivalent);
        LaneIndicators metres = InMetres(torcs, state.Indicators, scale);
        return _controller.Drive(state with
        {
            TorcsEquivalent = torcs with
            {
                DistL = Cut(metres.DistL),
                DistR = Cut(metres.DistR),
                DistLL = Cut(metres.DistLL),
                DistMM = Cut(metres.DistMM),
                DistRR = Cut(metres.DistRR),
            },
            Indicators = metres,
        });
    }

    /// <summary>Metres on the road for a metre on a road of TORCS.</summary>
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

    private LaneIndicators WithNoise(LaneIndicators at) => at with
    {
        Angle = Noisy(at.Angle, _levels.AngleRadians),
        ToMarkingL = Noisy(at.ToMarkingL, _levels.MarkingMetres),
        ToMarkingM = Noisy(at.ToMarkingM, _levels.MarkingMetres),
        ToMarkingR = Noisy(at.ToMarkingR, _levels.MarkingMetres),
        ToMarkingLL = Noisy(at.ToMarkingLL, _levels.MarkingMetres),
        ToMarkingML = Noisy(at.ToMarkingML, _levels.MarkingMetres),
        ToMarkingMR = Noisy(at.ToMarkingMR, _levels.MarkingMetres),
        ToMarkingRR = Noisy(at.ToMarkingRR, _levels.MarkingMetres),
    };

    private LaneIndicators InMetres(LaneIndicators torcs, LaneIndicators metres, double scale)
    {
        return torcs with
        {
            ToMarkingL = Scaled(torcs.ToMarkingL, metres.ToMarkingL),
            ToMarkingM = Scaled(torcs.ToMarkingM, metres.ToMarkingM),
            ToMarkingR = Scaled(torcs.ToMarkingR, metres.ToMarkingR),
            ToMarkingLL = Scaled(torcs.ToMarkingLL, metres.ToMarkingLL),
            ToMarkingML = Scaled(torcs.ToMarkingML, metres.ToMarkingML),
            ToMarkingMR = Scaled(torcs.ToMarkingMR, metres.ToMarkingMR),
            ToMarkingRR = Scaled(torcs.ToMarkingRR, metres.ToMarkingRR),
            DistL = NoisyDistance(metres.DistL),
            DistR = NoisyDistance(metres.DistR),
            DistLL = NoisyDistance(metres.DistLL),
            DistMM = NoisyDistance(metres.DistMM),
            DistRR = NoisyDistance(metres.DistRR),
        };

        Indicator Scaled(Indicator noisy, Indicator known) => noisy.IsValid ? Indicator.Of(noisy.Value * scale) : known;
    }

    private Indicator Noisy(Indicator indicator, double meanError) =>
        indicator.IsValid ? Indicator.Of(indicator.Value + (Normal() * meanError * DeviationByMeanError)) : indicator;

    private static Indicator Cut(Indicator indicator) =>
        indicator.IsValid ? Indicator.Of(Math.Min(indicator.Value, TorcsEquivalent.VehicleRange)) : indicator;

    private Indicator NoisyDistance(Indicator indicator) =>
        indicator.IsValid
            ? Indicator.Of(Math.Clamp(Noisy(indicator, _levels.VehicleMetres).Value, 0, IndicatorCalculator.VehicleRange))
            : indicator;

    /// <summary>A standard normal number by the formula of Box and Muller.</summary>
    private double Normal() =>
        Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
}

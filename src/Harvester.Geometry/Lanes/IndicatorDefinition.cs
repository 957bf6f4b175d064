namespace Harvester.Geometry.Lanes;

/// <summary>One of the thirteen indicators: a row of <see cref="IndicatorTable"/>.</summary>
public sealed class IndicatorDefinition
{
    private readonly Func<LaneIndicators, Indicator> _read;
    private readonly Func<LaneIndicators, Indicator, LaneIndicators> _replace;
    private readonly Func<double, double> _normalise;

    internal IndicatorDefinition(
        IndicatorQuantity quantity,
        string place,
        IndicatorRange range,
        double? activeLimit,
        Func<LaneIndicators, Indicator> read,
        Func<LaneIndicators, Indicator, LaneIndicators> replace,
        Func<double, double> normalise
    )
    {
        Quantity = quantity;
        Place = place;
        Range = range;
        ActiveLimit = activeLimit;
        _read = read;
        _replace = replace;
        _normalise = normalise;
    }

    /// <summary>What it measures: an angle, or a distance to a marking or a vehicle.</summary>
    public IndicatorQuantity Quantity { get; }

    /// <summary>The marking or lane it belongs to: L, M and R on a marking; LL, ML, MM, MR and RR in a lane; empty for the angle.</summary>
    public string Place { get; }

    /// <summary>Its name in labels and documentation, such as toMarkingLL.</summary>
    public string Name =>
        Quantity switch
        {
            IndicatorQuantity.Angle => "angle",
            IndicatorQuantity.ToMarking => "toMarking" + Place,
            _ => "dist" + Place,
        };

    /// <summary>Unit of its value: rad or m.</summary>
    public string Unit => Quantity == IndicatorQuantity.Angle ? "rad" : "m";

    /// <summary>Its values on lanes 4 metres wide, in <see cref="Unit"/>.</summary>
    public IndicatorRange Range { get; }

    /// <summary>
    /// The value beyond which an estimate counts as inactive: half-way between the largest valid value at this place on the road and the
    /// inactive value; null for the angle, which is always active.
    /// </summary>
    public double? ActiveLimit { get; }

    /// <summary>This indicator's value in a set.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="indicators"/> is null.</exception>
    public Indicator Of(LaneIndicators indicators) => _read(Guard.NotNull(indicators, nameof(indicators)));

    /// <summary>Returns a set with another value of this indicator.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="indicators"/> is null.</exception>
    public LaneIndicators Replace(LaneIndicators indicators, Indicator value) =>
        _replace(Guard.NotNull(indicators, nameof(indicators)), value);

    /// <summary>The value as DeepDriving's loss layer maps it (<see cref="DeepDrivingNormalisation"/>).</summary>
    /// <param name="torcsValue">A value scaled to a road of TORCS (<see cref="TorcsEquivalent"/>), in <see cref="Unit"/>.</param>
    public double Normalise(double torcsValue) => _normalise(torcsValue);

    /// <summary>The indicator for a value without a flag, as a network estimates it: inactive beyond <see cref="ActiveLimit"/>.</summary>
    /// <param name="torcsValue">A value scaled to a road of TORCS, in <see cref="Unit"/>.</param>
    public Indicator Estimate(double torcsValue)
    {
        bool isInactiveBelow = Range.InactiveValue < ActiveLimit;
        bool isActive = ActiveLimit is not { } limit || (isInactiveBelow ? torcsValue >= limit : torcsValue <= limit);
        return isActive ? Indicator.Of(torcsValue) : Range.Inactive;
    }
}

using System;
using System.Collections.Generic;
using Harvester.Geometry.Lanes;

namespace Harvester.Sessions.Labels;

/// <summary>The thirteen indicators by the names that they have in files, in the order of DeepDriving's training data.</summary>
public static class NamedIndicators
{
    /// <summary>Name of the only one that is an angle.</summary>
    public const string Angle = "angle";

    /// <summary>Names and indicators.</summary>
    public static IReadOnlyList<(string Name, Indicator Indicator)> Of(LaneIndicators indicators)
    {
        if (indicators is null)
        {
            throw new ArgumentNullException(nameof(indicators));
        }

        return
        [
            (Angle, indicators.Angle),
            ("toMarkingL", indicators.ToMarkingL),
            ("toMarkingM", indicators.ToMarkingM),
            ("toMarkingR", indicators.ToMarkingR),
            ("distL", indicators.DistL),
            ("distR", indicators.DistR),
            ("toMarkingLL", indicators.ToMarkingLL),
            ("toMarkingML", indicators.ToMarkingML),
            ("toMarkingMR", indicators.ToMarkingMR),
            ("toMarkingRR", indicators.ToMarkingRR),
            ("distLL", indicators.DistLL),
            ("distMM", indicators.DistMM),
            ("distRR", indicators.DistRR),
        ];
    }

    /// <summary>Indicators from their names.</summary>
    /// <param name="indicatorOf">Gives the indicator of a name.</param>
    public static LaneIndicators From(Func<string, Indicator> indicatorOf)
    {
        if (indicatorOf is null)
        {
            throw new ArgumentNullException(nameof(indicatorOf));
        }

        return new LaneIndicators
        {
            Angle = indicatorOf(Angle),
            ToMarkingL = indicatorOf("toMarkingL"),
            ToMarkingM = indicatorOf("toMarkingM"),
            ToMarkingR = indicatorOf("toMarkingR"),
            DistL = indicatorOf("distL"),
            DistR = indicatorOf("distR"),
            ToMarkingLL = indicatorOf("toMarkingLL"),
            ToMarkingML = indicatorOf("toMarkingML"),
            ToMarkingMR = indicatorOf("toMarkingMR"),
            ToMarkingRR = indicatorOf("toMarkingRR"),
            DistLL = indicatorOf("distLL"),
            DistMM = indicatorOf("distMM"),
            DistRR = indicatorOf("distRR"),
        };
    }
}

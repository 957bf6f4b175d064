using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;

namespace Harvester.Runs.Clients;

/// <summary>Indicators as a bridge sends them: numbers without validity flags.</summary>
public static class ClientIndicators
{
    /// <summary>The indicators. If no marking is in range, none is valid, not even the angle.</summary>
    public static LaneIndicators Of(IReadOnlyList<double> torcsEquivalent)
    {
        LaneIndicators indicators = IndicatorOrder.FromValues(torcsEquivalent);
        bool isOnRoad = indicators.ToMarkingM.IsValid || indicators.ToMarkingML.IsValid || indicators.ToMarkingMR.IsValid;
        return isOnRoad ? indicators : LaneIndicators.Unknown;
    }

    /// <summary>Indicators in metres, with the angle at the look-ahead point, which the TORCS equivalents do not have.</summary>
    public static LaneIndicators InMetres(LaneIndicators torcsEquivalent, LaneSection section, double angleAhead)
    {
        LaneIndicators metres = TorcsEquivalent.InMetres(torcsEquivalent, section);
        return metres.Angle.IsValid ? metres with { Angle = Indicator.Of(angleAhead) } : metres;
    }

    /// <summary>
    /// Lane width for which the indicators in metres equal the TORCS equivalents; the ordinary width if they do not determine it.
    /// </summary>
    public static LaneSection SectionOf(IReadOnlyList<double> torcsEquivalent, IReadOnlyList<double> metres)
    {
        LaneIndicators torcs = Of(torcsEquivalent);
        int known = IndicatorTable.IndexOf(torcs.ToMarkingMR.IsValid ? "toMarkingMR" : "toMarkingM");
        bool tells = (torcs.ToMarkingMR.IsValid || torcs.ToMarkingM.IsValid) && torcsEquivalent[known] * metres[known] > 0;
        return tells ? new LaneSection(1, LaneSection.TorcsLaneWidth * metres[known] / torcsEquivalent[known]) : Ordinary;
    }

    /// <summary>Lane width of ordinary roads.</summary>
    public static LaneSection Ordinary { get; } = new(1, Harvester.Geometry.Roads.RoadGeometry.LaneWidth);
}

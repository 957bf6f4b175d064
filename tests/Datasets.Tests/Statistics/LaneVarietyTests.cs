using Harvester.Datasets.Statistics;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Tests.Statistics;

public sealed class LaneVarietyTests
{
    [Fact]
    public void Indicators_are_counted_where_the_road_has_them()
    {
        LaneVariety variety = new();
        variety.Add(Lanes(-1, 1, LaneIndicators.Unknown with { ToMarkingML = Indicator.Of(-2) }));
        variety.Add(Lanes(1, 2, LaneIndicators.Unknown with { ToMarkingML = Indicator.Of(-4), DistRR = Indicator.Of(20) }));
        variety.Add(Lanes(0, 2, LaneIndicators.Unknown));
        variety.Add(Lanes(9, 2, LaneIndicators.Unknown) with { Status = LaneStatus.InJunction });

        Assert.Equal(3, variety.Frames);
        Assert.Equal(Math.Sqrt(2.0 / 3), variety.OffsetDeviationMetres, 1e-12);
        Assert.Equal((-1, 1), (variety.MinOffsetMetres, variety.MaxOffsetMetres));
        Assert.Equal(2.0 / 3, variety.ActiveFraction(IndicatorTable.IndexOf("toMarkingML")), 1e-12);
        Assert.Equal(3, variety.FramesWith(IndicatorTable.IndexOf("toMarkingML")));
        Assert.Equal(0.5, variety.ActiveFraction(IndicatorTable.IndexOf("distRR")), 1e-12);
        Assert.Equal(2, variety.FramesWith(IndicatorTable.IndexOf("distRR")));
        Assert.Equal(0, variety.ActiveFraction(IndicatorTable.IndexOf("toMarkingL")));
    }

    [Fact]
    public void Nothing_is_counted_without_known_lanes()
    {
        LaneVariety variety = new();

        Assert.Equal(0, variety.Frames);
        Assert.Equal(0, variety.OffsetDeviationMetres);
        Assert.Equal(0, variety.ActiveFraction(0));
    }

    private static LanesLabel Lanes(double offset, int lanes, LaneIndicators indicators) =>
        new()
        {
            Status = LaneStatus.Known,
            Source = "simulation",
            OffsetFromLaneCentreMetres = offset,
            LaneCount = lanes,
            Indicators = indicators,
        };
}

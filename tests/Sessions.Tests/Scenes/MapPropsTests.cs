using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Scenes;

public sealed class MapPropsTests
{
    [Theory]
    [InlineData("prop_traffic_01a", MapSignalKind.Light)]
    [InlineData("PROP_TRAFFIC_03B", MapSignalKind.Light)]
    [InlineData("prop_sign_road_01a", MapSignalKind.StopSign)]
    [InlineData("prop_sign_road_02a", MapSignalKind.GiveWay)]
    [InlineData("prop_traffic_rail_1a", null)]
    [InlineData("prop_streetlight_01", null)]
    public void Models_are_told_by_their_names(string model, MapSignalKind? kind) => Assert.Equal(kind, MapProps.KindOf(model));

    [Fact]
    public void Faces_look_backward_of_the_prop()
    {
        var placement = new PropPlacement("prop_traffic_01a", new Vector3D(1, 2, 3), new EulerAngles(0, 0, 90));

        MapProp prop = Assert.Single(MapProps.Of([placement, placement with { Name = "prop_bench_01a" }]));

        // Heading 90° faces west, so the lenses look east.
        Assert.Equal(1, prop.Facing.X, 1e-12);
        Assert.Equal(0, prop.Facing.Y, 1e-12);
        Assert.Equal(placement.Position, prop.Position);
    }

    [Fact]
    public void Speed_signs_have_limits_in_metres_per_second()
    {
        var placement = new PropPlacement("prop_sign_road_06e", new Vector3D(1, 2, 3), new EulerAngles(0, 0, 0));

        MapSpeedSign sign = Assert.Single(MapProps.SpeedSignsOf([placement, placement with { Name = "prop_sign_road_01a" }]));

        // 35 mph = 35 · 1609.344 m / 3600 s.
        Assert.Equal(15.6464, sign.Limit, 1e-4);
        Assert.Equal(new Vector3D(0, -1, 0), sign.Facing);
    }
}
